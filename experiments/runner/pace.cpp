#include "experiments/runner/pace.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "experiments/schedule/schedule.h"
#include "sim/world/rules/rule_set.h"

namespace runner {
namespace {

constexpr double night = 10 * 3600;  // [s]
// A game goes on a little after the time of each half: 1228.7 s of 1200 in the game of the README.
constexpr double overrun = 1.024;
// Of the time of its games, for a team to be called what makes them long (ours).
constexpr double greater_part = 0.5;

/// Three digits, or all before the point.
std::string text(double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), value < 100 ? "%.3g" : "%.0f", value);
  return text.data();
}

std::string takes(const Pace& pace, world::Team team) {
  return "team '" + pace.names[team] + "' takes " + text(1000 * pace.own[team]) +
         " ms of its own time a tick";
}

world::Team slower(const Pace& pace) {
  return pace.own.yellow > pace.own.blue ? world::Team::Yellow : world::Team::Blue;
}

}  // namespace

Pace pace_of(const record::MatchConfig& config, const std::vector<record::MatchRecord>& records,
             double games) {
  Pace pace;
  pace.games = games;
  double ticks = 0;
  for (const record::MatchRecord& record : records) {
    ticks += static_cast<double>(record.ticks);
    pace.tick += record.wall_seconds;
    for (const world::Team team : world::both_teams) {
      const auto own = record.costs.find(std::string("own_seconds_") + world::name(team));
      if (own != record.costs.end()) pace.own[team] += own->second;
    }
  }
  pace.tick = ticks > 0 ? pace.tick / ticks : 0;
  for (const world::Team team : world::both_teams) {
    pace.own[team] = ticks > 0 ? pace.own[team] / ticks : 0;
    pace.names[team] = config.teams[team].name;
  }
  return pace;
}

double full_game_ticks(const schedule::Design& design) {
  const double half = design.half_length.value_or(world::seconds(world::rule_set(design.rules).half_length));
  return 2 * half * overrun * world::ticks_per_second;
}

double expected_seconds(const schedule::Design& design, const std::vector<Pace>& paces, std::size_t places) {
  double sum = 0;
  for (const Pace& pace : paces) sum += pace.games * pace.tick;
  return sum * full_game_ticks(design) / static_cast<double>(places);
}

std::string budget_problem(const schedule::Design& design, const Pace& pace) {
  const world::Team team = slower(pace);
  const schedule::TeamTime& allowed = design.limits.team_time;
  const double second = pace.own[team] * world::ticks_per_second;
  const double game = pace.own[team] * full_game_ticks(design);
  const auto sentence = [&](double time, const std::string& what, double most, const char* key) {
    return takes(pace, team) + ", that is " + text(time) + " s" + " for " + what + ", and " + text(most) +
           " s" + " are allowed (limits." + key + "): it would lose every game by forfeit";
  };
  if (second > allowed.second) return sentence(second, "a simulated second", allowed.second, "team_second");
  if (game > allowed.game) return sentence(game, "a full game", allowed.game, "team_game");
  return "";
}

std::string slowest_team(const schedule::Design& design, const std::vector<Pace>& paces, std::size_t places) {
  const double seconds = expected_seconds(design, paces, places);
  if (seconds <= night || paces.empty()) return "";
  const auto slowest = std::max_element(paces.begin(), paces.end(), [](const Pace& one, const Pace& other) {
    return one.own[slower(one)] < other.own[slower(other)];
  });
  const world::Team team = slower(*slowest);
  if (slowest->own[team] < greater_part * slowest->tick) return "";
  return "the games take longer than a night of 10 h: " + takes(*slowest, team) + " of " +
         text(1000 * slowest->tick) + " ms in all; with it the " +
         std::to_string(schedule::game_count(design)) + " games take " + text(seconds / 3600) + " h";
}

}  // namespace runner
