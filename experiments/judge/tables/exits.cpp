#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"

namespace judge {

Table exits_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{
      "a_exits",
      "a) Exits (the paper's Figure 9)",
      "Last team right of the clear exits that were called, with Wilson's 95 % interval. Ambiguous: "
      "robots of "
      "both teams touched within one frame. Close: the ball got less than a band beyond the line. "
      "Chip extra: "
      "called while the ball was in the air. Found: called, of the clear exits. Extra in 1000: of both "
      "kinds, calls without an exit for each thousand clear exits. Delay: median and 95 % in ms.",
      {"referee", "clear exits", "correct", "last touch wrong", "missed", "extra", "chip extra", "ambiguous",
       "of them missed", "close", "last team right", "found", "extra in 1000", "within 0.1 s", "delay", ""},
      {}};
  for (const std::string& shadow : shadows_of(games)) {
    const Cases cases = cases_of(games, shadow, is_exit);
    const ExitClasses all(cases);
    table.rows.push_back(
        {shadow, whole(all.clear), whole(all.correct), whole(all.wrong), whole(all.missed), whole(all.extra),
         whole(all.chip), whole(all.ambiguous), whole(all.ambiguous_missed), whole(all.close),
         share(all.correct, all.correct + all.wrong), share(all.correct + all.wrong, all.clear),
         all.clear > 0 ? fmt::format("{:.2f}", 1000.0 * (all.extra + all.chip) / all.clear) : "",
         whole(all.within_tenth), delays(cases), all.clear < wanted.exits ? "too few" : ""});
  }
  return table;
}

/// How many of the exits, goals and calls were of the kinds that are hard.
Table situations_table(std::span<const GameResult> games) {
  Table table{
      "a_situations",
      "a) What happened",
      "True exits beyond their band, called or not, by what made them hard: how many, and how many of "
      "those that one team alone touched last were called with the right team by the acting referee.",
      {"exits", "count", "of all", "one team last", "called with the right team", "missed"},
      {}};
  const Cases exits = cases_of(games, acting_name, [](const Case& one) {
    return is_exit(one) && one.truth && one.truth->last && !one.close();
  });
  const auto row = [&](const std::string& what, const std::function<bool(const TrueEvent&)>& is) {
    int count = 0, single = 0, right = 0, missed = 0;
    for (const Case* exit : exits) {
      if (!is(*exit->truth)) continue;
      ++count;
      if (exit->ambiguous()) continue;
      ++single;
      right += exit->team_is_right();
      missed += exit->result == Result::Missed;
    }
    table.rows.push_back({what, whole(count), share(count, std::ssize(exits)), whole(single),
                          share(right, single), whole(missed)});
  };
  row("all", [](const TrueEvent&) { return true; });
  row("chipped: higher than a robot since the last touch",
      [](const TrueEvent& exit) { return exit.last->chip; });
  row("squeezed between robots", [](const TrueEvent& exit) { return exit.last->kind == Kind::Squeeze; });
  row("crowded: both teams within 150 mm", [](const TrueEvent& exit) { return exit.last->crowded; });
  row("ambiguous: both teams within one frame", [](const TrueEvent& exit) { return exit.ambiguous; });
  row("at the line: touched in the last two ticks", [](const TrueEvent& exit) { return exit.last->at_line; });
  row("deflected", [](const TrueEvent& exit) { return exit.last->kind == Kind::Deflection; });
  row("over the crossbar", [](const TrueEvent& exit) { return exit.over_goal; });
  row("ball lost for a tick or more", [](const TrueEvent& exit) { return exit.last->lost > 0; });
  return table;
}

}  // namespace judge
