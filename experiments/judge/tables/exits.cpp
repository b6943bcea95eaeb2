#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/judge/tables/counting.h"
#include "experiments/judge/tables/parts.h"

namespace judge {
namespace {

constexpr double gentle = 0.016;  // [N s] a change of the ball's velocity of 0.35 m/s: ours
constexpr double quarrel = 0.1;   // [s] ours

/// What makes an exit hard to judge.
struct Situation {
  const char* text;
  bool (*is)(const TrueEvent& exit);
};
constexpr std::array situations = {
    Situation{"at the line: touched in the last two ticks",
              [](const TrueEvent& exit) { return exit.last->at_line; }},
    Situation{"squeezed between robots of both teams",
              [](const TrueEvent& exit) { return exit.last->kind == Kind::Squeeze; }},
    Situation{"crowded: both teams within 150 mm", [](const TrueEvent& exit) { return exit.last->crowded; }},
    Situation{"hidden: no camera saw the ball for a tick or more since the last touch",
              [](const TrueEvent& exit) { return exit.last->lost > 0; }},
    Situation{"chipped: higher than a robot since the last touch",
              [](const TrueEvent& exit) { return exit.last->chip; }},
    Situation{"gentle: last touch under 16 mN s",
              [](const TrueEvent& exit) { return exit.last->impulse < gentle; }},
    Situation{"quarrelled: the other team touched less than 0.1 s before the last touch",
              [](const TrueEvent& exit) { return exit.last->alone < quarrel; }}};

bool any_situation(const TrueEvent& exit) {
  return std::ranges::any_of(situations, [&](const Situation& one) { return one.is(exit); });
}

}  // namespace

Table exits_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{
      "a_exits",
      "a1) Exits (the paper's Figure 9)",
      "Last team right of the clear exits that were called, with Wilson's 95 % interval. Ambiguous: robots "
      "of "
      "both teams touched within one frame. Close: the ball got less than a band beyond the line. Chip "
      "extra: "
      "called while the ball was in the air. Found: called, of the clear and the ambiguous exits. Extra in "
      "1000: of both kinds, calls without an exit for each thousand clear exits. Delay: median and 95 % in "
      "ms.",
      {"referee", "clear exits", "correct", "last touch wrong", "missed", "extra", "chip extra", "ambiguous",
       "ambiguous missed", "close", "last team right", "found", "extra in 1000", "within 0.1 s", "delay",
       "remark"},
      {}};
  for (const std::string& shadow : shadows_of(games)) {
    const Cases cases = cases_of(games, shadow, is_exit);
    const ExitClasses all(cases);
    table.rows.push_back(
        {shadow, whole(all.clear), whole(all.correct), whole(all.wrong), whole(all.missed), whole(all.extra),
         whole(all.chip), whole(all.ambiguous), whole(all.ambiguous_missed), whole(all.close),
         share(all.correct, all.correct + all.wrong), share(all.all() - all.all_missed(), all.all()),
         all.clear > 0 ? fmt::format("{:.2f}", all.extra_in_1000()) : "", whole(all.within_tenth),
         delays(cases), too_few(all.clear, wanted.exits, "clear exits")});
  }
  return table;
}

/// How many of the exits, goals and calls were of the kinds that are hard.
Table situations_table(std::span<const GameResult> games) {
  Table table{
      "a_situations",
      "a2) What happened",
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
  for (const Situation& one : situations) row(one.text, one.is);
  row("none of these", [](const TrueEvent& exit) { return !any_situation(exit); });
  row("ambiguous: both teams within one frame", [](const TrueEvent& exit) { return exit.ambiguous; });
  row("deflected", [](const TrueEvent& exit) { return exit.last->kind == Kind::Deflection; });
  row("over the crossbar", [](const TrueEvent& exit) { return exit.over_goal; });
  return table;
}

Table failing_exits_table(std::span<const GameResult> games) {
  Table table{
      "a_failing",
      "a3) What failing exits have in common",
      "Clear exits that the acting referee missed or gave to the wrong team, against all clear exits. "
      "One may be several of these. Each case: failures.csv.",
      {"exits", "of the failing", "of all"},
      {}};
  const Cases all = cases_of(games, acting_name, [](const Case& one) { return clear_exit(one); });
  const Cases failing =
      cases_of(games, acting_name, [](const Case& one) { return clear_exit(one) && !one.team_is_right(); });
  const auto row = [&](const std::string& what, bool (*is)(const TrueEvent&)) {
    const auto count = [&](const Cases& cases) {
      return std::ranges::count_if(cases, [&](const Case* one) { return is(*one->truth); });
    };
    table.rows.push_back(
        {what, share(count(failing), std::ssize(failing)), share(count(all), std::ssize(all))});
  };
  for (const Situation& one : situations) row(one.text, one.is);
  row("none of these", [](const TrueEvent& exit) { return !any_situation(exit); });
  return table;
}

}  // namespace judge
