#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"

namespace judge {

Table goals_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{"c_goals",
              "c) Goals (the paper's Table 9)",
              "True goals count; a chip goal does not, where the rule set knows it. False from chip: called "
              "a goal while "
              "the ball was in the air and no goal was made.",
              {"referee", "true goals", "called", "missed", "false", "false from chip", "recall", "precision",
               "close", "true chip goals", "called ", "missed ", "false ", "delay", " "},
              {}};
  for (const std::string& shadow : shadows_of(games)) {
    const Cases goals = cases_of(games, shadow, [](const Case& one) { return one.event == Event::Goal; });
    const Cases chips =
        cases_of(games, shadow, [](const Case& one) { return one.event == Event::ChippedGoal; });
    const auto count = [](const Cases& cases, Result result, std::optional<bool> chip = {}) {
      return std::ranges::count_if(cases, [&](const Case* one) {
        return one->result == result && !one->close() && (!chip || one->chip == *chip);
      });
    };
    const auto close = std::ranges::count_if(goals, [](const Case* one) { return one->close(); });
    const auto found = count(goals, Result::Found);
    const auto missed = count(goals, Result::Missed);
    table.rows.push_back({shadow, whole(found + missed), whole(found), whole(missed),
                          whole(count(goals, Result::Extra, false)), whole(count(goals, Result::Extra, true)),
                          share(found, found + missed), share(found, found + count(goals, Result::Extra)),
                          whole(close), whole(count(chips, Result::Found) + count(chips, Result::Missed)),
                          whole(count(chips, Result::Found)), whole(count(chips, Result::Missed)),
                          whole(count(chips, Result::Extra)), delays(goals),
                          found + missed < wanted.goals ? "too few" : ""});
  }
  return table;
}

}  // namespace judge
