#include "experiments/judge/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "experiments/stats/intervals.h"
#include "experiments/stats/sign_test.h"

namespace judge {
namespace {

using Cases = std::vector<const Case*>;

Cases cases_of(std::span<const GameResult> games, const std::string& shadow,
               const std::function<bool(const Case&)>& wanted) {
  Cases found;
  for (const GameResult& game : games) {
    for (const Case& one : game.cases) {
      if (one.shadow == shadow && wanted(one)) found.push_back(&one);
    }
  }
  return found;
}

std::vector<std::string> shadows_of(std::span<const GameResult> games) {
  std::vector<std::string> names;
  for (const GameResult& game : games) {
    for (const std::string& name : game.shadows) {
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

std::string share(std::int64_t good, std::int64_t n) {
  if (n == 0) return "none";
  const stats::Interval interval = stats::wilson(good, n);
  return fmt::format("{}/{} = {:.3f} [{:.3f}, {:.3f}]", good, n,
                     static_cast<double>(good) / static_cast<double>(n), interval.low, interval.high);
}

std::string whole(std::int64_t number) { return std::to_string(number); }

/// The value below which that share of the sorted ones lies.
double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (sorted[above] - sorted[below]) * (place - static_cast<double>(below));
}

std::string delays(const Cases& cases) {
  std::vector<double> all;
  for (const Case* one : cases) {
    if (one->result == Result::Found && !one->close()) {
      all.push_back(1000 * world::seconds(one->call->reported - one->truth->time));
    }
  }
  if (all.empty()) return "";
  std::ranges::sort(all);
  return fmt::format("{:.0f}, {:.0f}", quantile(all, 0.5), quantile(all, 0.95));
}

bool is_exit(const Case& one) { return one.event == Event::Exit; }
bool clear_exit(const Case& one) {
  return is_exit(one) && one.result != Result::Extra && !one.close() && !one.ambiguous();
}

/// The classes of the paper's Figure 9.
struct ExitClasses {
  int clear = 0, correct = 0, wrong = 0, missed = 0, extra = 0, chip = 0, ambiguous = 0, ambiguous_missed = 0,
      close = 0, within_tenth = 0;
  explicit ExitClasses(const Cases& cases) {
    for (const Case* one : cases) {
      if (one->result == Result::Extra) {
        ++(one->chip ? chip : extra);
      } else if (one->close()) {
        ++close;
      } else if (one->ambiguous()) {
        ++ambiguous;
        if (one->result == Result::Missed) ++ambiguous_missed;
      } else {
        ++clear;
        if (one->result == Result::Missed) {
          ++missed;
        } else {
          ++(one->team_is_right() ? correct : wrong);
          if (std::abs(world::seconds(one->call->time - one->truth->time)) <= 0.1) ++within_tenth;
        }
      }
    }
  }
};

Table exits_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{"a_exits",
              "a) Exits (the paper's Figure 9)",
              "Last team right of the clear exits that were called, with Wilson's 95 % interval. Ambiguous: "
              "robots of "
              "both teams touched within one frame. Close: the ball got less than a band beyond the line. "
              "Chip extra: "
              "called while the ball was in the air. Delay: median and 95 % in ms.",
              {"referee", "clear exits", "correct", "last touch wrong", "missed", "extra", "chip extra",
               "ambiguous", "of them missed", "close", "last team right", "within 0.1 s", "delay", ""},
              {}};
  for (const std::string& shadow : shadows_of(games)) {
    const Cases cases = cases_of(games, shadow, is_exit);
    const ExitClasses all(cases);
    table.rows.push_back({shadow, whole(all.clear), whole(all.correct), whole(all.wrong), whole(all.missed),
                          whole(all.extra), whole(all.chip), whole(all.ambiguous),
                          whole(all.ambiguous_missed), whole(all.close),
                          share(all.correct, all.correct + all.wrong), whole(all.within_tenth), delays(cases),
                          all.clear < wanted.exits ? "too few" : ""});
  }
  return table;
}

/// What each witness said at each clear exit that the acting referee's detectors called.
struct Sayings {
  std::vector<std::string> witnesses;
  std::vector<const Case*> exits;

  bool right(std::size_t witness, const Case& exit) const {
    if (witness >= exit.call->witnesses.size()) return false;
    const auto& said = exit.call->witnesses[witness];
    return said && said->robot.team == exit.truth->last->robot.team;
  }
};

Sayings sayings_of(std::span<const GameResult> games) {
  Sayings sayings;
  if (games.empty()) return sayings;
  sayings.witnesses = games.front().witnesses;
  sayings.exits = cases_of(games, acting_name,
                           [](const Case& one) { return clear_exit(one) && one.result == Result::Found; });
  return sayings;
}

Table touch_teams_table(std::span<const GameResult> games, const Wanted& wanted) {
  const Sayings sayings = sayings_of(games);
  const auto rows = sayings.witnesses.size();
  const auto three =
      static_cast<std::size_t>(std::ranges::find(sayings.witnesses, "all three") - sayings.witnesses.begin());
  Table table{
      "b_last_touch",
      "b) Last touching team (the paper's Table 8)",
      "At the same clear exits, as called by the acting referee's detectors. p: McNemar's exact two-sided "
      "test.",
      {"touches by", "last team right", "last robot right", "p against all three", "p against the row above"},
      {}};
  const auto mcnemar = [&](std::size_t a, std::size_t b) {
    int only_a = 0;
    int only_b = 0;
    for (const Case* exit : sayings.exits) {
      const bool first = sayings.right(a, *exit);
      const bool second = sayings.right(b, *exit);
      only_a += first && !second;
      only_b += second && !first;
    }
    return fmt::format("{:.2g} ({}:{})", stats::sign_test(only_a, only_b), only_a, only_b);
  };
  for (std::size_t w = 0; w < rows; ++w) {
    int good = 0;
    int robot = 0;
    for (const Case* exit : sayings.exits) {
      good += sayings.right(w, *exit);
      robot += sayings.right(w, *exit) && exit->call->witnesses[w]->robot == exit->truth->last->robot;
    }
    const auto n = static_cast<std::int64_t>(sayings.exits.size());
    table.rows.push_back({sayings.witnesses[w], share(good, n), share(robot, n),
                          w == three || three >= rows ? "" : mcnemar(w, three),
                          w == 0 ? "" : mcnemar(w, w - 1)});
  }
  if (static_cast<int>(sayings.exits.size()) < wanted.exits)
    table.rows.push_back({"too few exits", "", "", "", ""});
  return table;
}

Table strata_table(std::span<const GameResult> games) {
  const Sayings sayings = sayings_of(games);
  Table table{"g_strata",
              "g) Last touching team by what happened",
              "Clear exits. Lost: the longest stretch of ticks in which no camera saw the ball from its last "
              "touch to "
              "the exit. Crowded: robots of both teams within 150 mm of the ball at the touch.",
              {"exits", "count"},
              {}};
  for (const std::string& witness : sayings.witnesses) table.columns.push_back(witness);
  const auto row = [&](const std::string& what, const std::function<bool(const Case&)>& wanted) {
    Cases exits;
    for (const Case* exit : sayings.exits) {
      if (wanted(*exit)) exits.push_back(exit);
    }
    std::vector<std::string> fields = {what, whole(static_cast<std::int64_t>(exits.size()))};
    for (std::size_t w = 0; w < sayings.witnesses.size(); ++w) {
      const auto good =
          std::ranges::count_if(exits, [&](const Case* exit) { return sayings.right(w, *exit); });
      fields.push_back(share(good, static_cast<std::int64_t>(exits.size())));
    }
    table.rows.push_back(std::move(fields));
  };
  row("all", [](const Case&) { return true; });
  for (std::size_t k = 0; k < kinds; ++k) {
    const Kind kind = static_cast<Kind>(k);
    row(std::string(name(kind)), [=](const Case& one) { return one.truth->last->kind == kind; });
  }
  row("at the line", [](const Case& one) { return one.truth->last->at_line; });
  row("chip", [](const Case& one) { return one.truth->last->chip; });
  row("crowded", [](const Case& one) { return one.truth->last->crowded; });
  row("never lost", [](const Case& one) { return one.truth->last->lost == 0; });
  row("lost 1 to 3 ticks",
      [](const Case& one) { return one.truth->last->lost >= 1 && one.truth->last->lost <= 3; });
  row("lost 4 to 10 ticks",
      [](const Case& one) { return one.truth->last->lost >= 4 && one.truth->last->lost <= 10; });
  row("lost longer", [](const Case& one) { return one.truth->last->lost > 10; });
  return table;
}

Table sweep_table(std::span<const GameResult> games) {
  Table table{
      "g_sweeps",
      "g) Other eyes, other parameters",
      "Each referee sees the same games through cameras of its own, with the same random numbers. McNemar's "
      "test "
      "compares correct calls of clear exits with the acting referee's.",
      {"referee", "last team right", "missed exits", "extra", "chip extra", "p against ours", "delay"},
      {}};
  for (const std::string& shadow : shadows_of(games)) {
    const Cases cases = cases_of(games, shadow, is_exit);
    const ExitClasses all(cases);
    int only_it = 0;
    int only_ours = 0;
    for (const GameResult& game : games) {
      std::vector<std::pair<world::Time, bool>> ours;
      for (const Case& one : game.cases) {
        if (one.shadow == acting_name && clear_exit(one))
          ours.emplace_back(one.truth->time, one.team_is_right());
      }
      for (const Case& one : game.cases) {
        if (one.shadow != shadow || !clear_exit(one)) continue;
        const auto same = std::ranges::find(ours, one.truth->time, &std::pair<world::Time, bool>::first);
        if (same == ours.end()) continue;
        only_it += one.team_is_right() && !same->second;
        only_ours += same->second && !one.team_is_right();
      }
    }
    table.rows.push_back(
        {shadow, share(all.correct, all.correct + all.wrong), share(all.missed, all.clear), whole(all.extra),
         whole(all.chip),
         shadow == acting_name
             ? ""
             : fmt::format("{:.2g} ({}:{})", stats::sign_test(only_it, only_ours), only_it, only_ours),
         delays(cases)});
  }
  return table;
}

Table goals_table(std::span<const GameResult> games, const Wanted& wanted) {
  Table table{"c_goals",
              "c) Goals (the paper's Table 9)",
              "True goals count; a chip goal does not, where the rule set knows it. False from chip: called "
              "a goal while "
              "the ball was in the air and no goal was made.",
              {"referee", "true goals", "called", "missed", "false", "false from chip", "close",
               "true chip goals", "called ", "missed ", "false ", "delay", " "},
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
                          whole(close), whole(count(chips, Result::Found) + count(chips, Result::Missed)),
                          whole(count(chips, Result::Found)), whole(count(chips, Result::Missed)),
                          whole(count(chips, Result::Extra)), delays(goals),
                          found + missed < wanted.goals ? "too few" : ""});
  }
  return table;
}

std::vector<std::string> event_row(std::span<const GameResult> games, const std::string& shadow, Event event,
                                   const Wanted& wanted) {
  const Cases cases = cases_of(games, shadow, [&](const Case& one) { return one.event == event; });
  int found = 0, missed = 0, extra = 0, close_called = 0, close = 0, right = 0, named = 0, ambiguous = 0,
      tenth = 0;
  for (const Case* one : cases) {
    if (one->result == Result::Extra) {
      ++extra;
    } else if (one->ambiguous()) {
      ++ambiguous;
    } else if (one->close()) {
      ++close;
      if (one->result == Result::Found) ++close_called;
    } else if (one->result == Result::Missed) {
      ++missed;
    } else {
      ++found;
      if (std::abs(world::seconds(one->call->time - one->truth->time)) <= 0.1) ++tenth;
      if (one->truth->by && one->call->by) {
        ++named;
        const bool team_only = event == Event::TooManyRobots;
        right += team_only ? one->truth->by->team == one->call->by->team : *one->truth->by == *one->call->by;
      }
    }
  }
  int near_misses = 0;
  for (const GameResult& game : games) near_misses += game.near_misses[static_cast<std::size_t>(event)];
  const bool few = found + missed < wanted.events || near_misses < wanted.near_misses;
  return {std::string(name(event)),
          whole(found + missed),
          whole(near_misses),
          share(found, found + extra),
          share(found, found + missed),
          whole(tenth),
          named > 0 ? fmt::format("{}/{}", right, named) : "",
          delays(cases),
          fmt::format("{}/{}", close_called, close),
          whole(ambiguous),
          few ? "too few" : ""};
}

const std::vector<std::string> event_columns = {
    "event",       "true",  "near misses",      "precision", "recall", "within 0.1 s",
    "right robot", "delay", "close: called of", "ambiguous", ""};
constexpr const char* event_note =
    "True: beyond the limit by at least a band. Near misses: lawful, within two bands of the limit. Close: "
    "within one "
    "band on either side, outside precision and recall. Delay: median and 95 % in ms.";

Table events_table(std::span<const GameResult> games, const Wanted& wanted, bool speed) {
  Table table{speed ? "d_ball_speed" : "e_events",
              speed ? "d) Ball speed" : "e) Every other event of the catalogue",
              event_note,
              event_columns,
              {}};
  for (const std::string& shadow : shadows_of(games)) {
    if (shadow != acting_name && shadow != "rules=paper") continue;
    for (const Event event : all_events()) {
      if (event == Event::Exit || event == Event::Goal) continue;
      if ((event == Event::BallTooFast) != speed) continue;
      if (shadow != acting_name) {
        const world::RuleSet& paper = world::rule_set("paper");
        if (!world::runs(paper, detector_of(event))) continue;
      }
      std::vector<std::string> row = event_row(games, shadow, event, wanted);
      if (shadow != acting_name) row.front() += " (" + shadow + ")";
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table calibration_table(std::span<const GameResult> games) {
  Table table{"f_calibration",
              "f) The last touch's probability",
              "Of the likelihood, at clear exits. Brier: mean square of the difference between what was said "
              "and what "
              "was (0: perfect; 0.25: a coin).",
              {"probability said", "exits", "mean said", "right team"},
              {}};
  const Sayings sayings = sayings_of(games);
  const auto it = std::ranges::find(sayings.witnesses, "likelihood");
  if (it == sayings.witnesses.end()) return table;
  const auto w = static_cast<std::size_t>(it - sayings.witnesses.begin());
  constexpr std::array bounds = {0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.97, 0.99, 1.0001};
  double brier = 0;
  int all = 0;
  for (std::size_t b = 0; b + 1 < bounds.size(); ++b) {
    int n = 0;
    int good = 0;
    double sum = 0;
    for (const Case* exit : sayings.exits) {
      const auto& said = exit->call->witnesses.at(w);
      if (!said || said->probability < bounds[b] || said->probability >= bounds[b + 1]) continue;
      const bool right = sayings.right(w, *exit);
      ++n;
      good += right;
      sum += said->probability;
      brier += std::pow(said->probability - (right ? 1 : 0), 2);
    }
    all += n;
    table.rows.push_back({fmt::format("{:.2f} to {:.2f}", bounds[b], std::min(bounds[b + 1], 1.0)), whole(n),
                          n > 0 ? fmt::format("{:.3f}", sum / n) : "", share(good, n)});
  }
  table.rows.push_back(
      {"Brier score", whole(all), "", all > 0 ? fmt::format("{:.4f}", brier / all) : "none"});
  return table;
}

Table touches_table(std::span<const GameResult> games) {
  Table table{"h_touches",
              "h) Touches in play",
              "Impulse of a substep above 1 mN s, 50 ms apart. Recall by kind; precision over all; again: "
              "named once more "
              "within a touch that was found.",
              {"touches by", "window"},
              {}};
  for (std::size_t k = 0; k < kinds; ++k) table.columns.emplace_back(name(static_cast<Kind>(k)));
  for (const char* column : {"all", "precision", "extra", "again"}) table.columns.emplace_back(column);
  std::vector<TouchCount> sums;
  for (const GameResult& game : games) {
    for (const TouchCount& count : game.touches) {
      auto sum = std::ranges::find_if(sums, [&](const TouchCount& one) {
        return one.witness == count.witness && one.window == count.window;
      });
      if (sum == sums.end()) {
        sums.push_back(count);
        continue;
      }
      for (std::size_t k = 0; k < kinds; ++k) {
        sum->found[k] += count.found[k];
        sum->missed[k] += count.missed[k];
      }
      sum->extra += count.extra;
      sum->again += count.again;
    }
  }
  for (const TouchCount& sum : sums) {
    std::vector<std::string> row = {sum.witness, fmt::format("{:.1f} s", sum.window)};
    int found = 0;
    int all = 0;
    for (std::size_t k = 0; k < kinds; ++k) {
      row.push_back(share(sum.found[k], sum.found[k] + sum.missed[k]));
      found += sum.found[k];
      all += sum.found[k] + sum.missed[k];
    }
    row.push_back(share(found, all));
    row.push_back(share(found, found + sum.extra));
    row.push_back(whole(sum.extra));
    row.push_back(whole(sum.again));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Wanted wanted_of(std::string_view preset) {
  if (preset == "harsh") return {.exits = 1000};
  return {};
}

std::vector<Table> tables(std::span<const GameResult> games) {
  const Wanted wanted = wanted_of(games.empty() ? "" : games.front().preset);
  return {exits_table(games, wanted),
          touch_teams_table(games, wanted),
          goals_table(games, wanted),
          events_table(games, wanted, true),
          events_table(games, wanted, false),
          calibration_table(games),
          strata_table(games),
          sweep_table(games),
          touches_table(games)};
}

}  // namespace judge
