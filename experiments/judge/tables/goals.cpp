#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"

namespace judge {

Table goals_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{
      "c_goals",
      "c) Goals (the paper's Table 9)",
      "True goals count; a chip goal does not, where the rule set knows it: it is a true chip goal, and "
      "found when it is called one. False goal from a chip: called a goal while the ball was in the air "
      "and no goal was made. Close: less than a band behind the line, under the bar or from a chip. Delay of "
      "goals: "
      "median and 95 % in ms.",
      {"referee", "true goals", "goals called", "goals missed", "false goals", "false goals from chips",
       "recall", "precision", "close goals", "true chip goals", "chip goals called", "chip goals missed",
       "false chip goals", "delay", "remark"},
      {}};
  for (const std::string& shadow : shadows_of(games)) {
    const GoalClasses all(games, shadow);
    table.rows.push_back({shadow, whole(all.goals), whole(all.found), whole(all.missed), whole(all.extra),
                          whole(all.chip_extra), share(all.found, all.goals),
                          share(all.found, all.found + all.extra + all.chip_extra), whole(all.close),
                          whole(all.chips), whole(all.chips_found), whole(all.chips - all.chips_found),
                          whole(all.chips_extra), all.delay, too_few(all.goals, wanted.goals, "goals")});
  }
  return table;
}

}  // namespace judge
