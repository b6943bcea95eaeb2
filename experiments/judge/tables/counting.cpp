#include "experiments/judge/tables/counting.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/stats/intervals.h"

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
