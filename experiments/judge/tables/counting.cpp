#include "experiments/judge/tables/counting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/judge/net/reported.h"
#include "experiments/stats/intervals.h"
#include "sim/world/rules/rule_set.h"

namespace judge {
namespace {

/// The value below which that share of the sorted ones lies.
double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (sorted[above] - sorted[below]) * (place - static_cast<double>(below));
}

}  // namespace

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

std::string too_few(std::int64_t there, int wanted, const std::string& what) {
  return there < wanted ? "too few " + what : "";
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

ExitClasses::ExitClasses(const Cases& cases) {
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

EventClasses::EventClasses(std::span<const GameResult> games, const std::string& shadow, Event event) {
  for (const Case* one : cases_of(games, shadow, [&](const Case& its) { return its.event == event; })) {
    if (one->result == Result::Extra) {
      ++extra;
    } else if (one->ambiguous()) {
      ++ambiguous;
    } else if (one->close()) {
      ++close;
      close_called += one->result == Result::Found;
    } else if (one->result == Result::Missed) {
      ++missed;
    } else if (one->late()) {
      ++late;
    } else {
      ++found;
      within_tenth += std::abs(world::seconds(one->call->time - one->truth->time)) <= 0.1;
      if (one->truth->by && one->call->by) {
        ++named;
        const bool team_only = event == Event::TooManyRobots;
        right_robot +=
            team_only ? one->truth->by->team == one->call->by->team : *one->truth->by == *one->call->by;
      }
    }
  }
  for (const GameResult& game : games) near_misses += game.near_misses[static_cast<std::size_t>(event)];
}

GoalClasses::GoalClasses(std::span<const GameResult> games, const std::string& shadow) {
  const Cases of_goals = cases_of(games, shadow, [](const Case& one) { return one.event == Event::Goal; });
  for (const Case* one : of_goals) {
    if (one->close()) {
      ++close;
    } else if (one->result == Result::Extra) {
      ++(one->chip ? chip_extra : extra);
    } else {
      ++(one->result == Result::Found ? found : missed);
    }
  }
  goals = found + missed;
  delay = delays(of_goals);
  for (const Case* one :
       cases_of(games, shadow, [](const Case& its) { return its.event == Event::ChippedGoal; })) {
    if (one->close()) continue;
    chips += one->result != Result::Extra;
    chips_found += one->result == Result::Found;
    chips_extra += one->result == Result::Extra;
  }
}

namespace {
constexpr std::string_view by_rules = "rules=";
}  // namespace

bool is_other_referee(const std::string& shadow) {
  const bool eyes_too = shadow.find(',') != std::string::npos;
  return shadow == acting_name || shadow.starts_with("net") || (shadow.starts_with(by_rules) && !eyes_too);
}

bool may_call(const std::string& shadow, Event event) {
  if (shadow.starts_with("net")) return can_be_reported(event);
  if (!shadow.starts_with(by_rules)) return true;
  return world::runs(world::rule_set(shadow.substr(by_rules.size())), detector_of(event));
}

std::pair<int, int> Sayings::against(std::size_t a, std::size_t b) const {
  std::pair<int, int> only;
  for (const Case* exit : exits) {
    const bool first = right(a, *exit);
    const bool second = right(b, *exit);
    only.first += first && !second;
    only.second += second && !first;
  }
  return only;
}

std::optional<std::size_t> Sayings::witness(const std::string& name) const {
  const auto it = std::ranges::find(witnesses, name);
  if (it == witnesses.end()) return std::nullopt;
  return static_cast<std::size_t>(it - witnesses.begin());
}

std::string brier(const std::vector<std::pair<double, bool>>& said) {
  if (said.empty()) return "";
  double sum = 0;
  for (const auto& [probability, right] : said) sum += std::pow(probability - (right ? 1 : 0), 2);
  return fmt::format("{:.4f}", sum / static_cast<double>(said.size()));
}

bool Sayings::right(std::size_t witness, const Case& exit) const {
  if (witness >= exit.call->witnesses.size()) return false;
  const auto& said = exit.call->witnesses[witness];
  return said && said->robot.team == exit.truth->last->robot.team;
}

Sayings sayings_of(std::span<const GameResult> games) {
  Sayings sayings;
  if (games.empty()) return sayings;
  sayings.witnesses = games.front().witnesses;
  sayings.exits = cases_of(games, acting_name,
                           [](const Case& one) { return clear_exit(one) && one.result == Result::Found; });
  return sayings;
}

}  // namespace judge
