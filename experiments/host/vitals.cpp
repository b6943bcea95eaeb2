#include "experiments/host/vitals.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace host {

void Vitals::add(const truth::Frame& truth, const world::PerTeam<world::TeamCommands>& commands,
                 const world::RefereeMessage& message, const world::GameState& state) {
  if (first_.empty()) {
    first_ = truth.robots;
    first_command_ = message.command_counter;
  }
  heard_ = heard_ || message.command_counter != first_command_;
  const bool in_play = state.location == world::Location::GameOn;
  in_play_ = in_play_ || in_play;

  for (const truth::Robot& robot : truth.robots) {
    const auto first = std::find_if(first_.begin(), first_.end(),
                                    [&](const truth::Robot& other) { return other.id == robot.id; });
    if (first == first_.end()) continue;
    double& way = way_[robot.id.team];
    way = std::max(way, (robot.position - first->position).norm());
  }
  for (const world::Team team : world::both_teams) {
    const world::TeamCommands& its = commands[team];
    commanded_[team] =
        commanded_[team] || std::any_of(its.begin(), its.end(), [](const world::RobotCommand& command) {
          return !command.velocity_local.isZero(0) || command.angular_velocity != 0;
        });
  }
  if (state.location == world::Location::GameOff) count(truth, message);
}

void Vitals::count(const truth::Frame& truth, const world::RefereeMessage& message) {
  for (const world::Team team : world::both_teams) {
    const auto is_its = [team](const truth::Robot& robot) { return robot.id.team == team; };
    const auto present = static_cast<int>(std::count_if(truth.robots.begin(), truth.robots.end(), is_its));
    const auto all = static_cast<int>(std::count_if(first_.begin(), first_.end(), is_its));
    // The keeper is never taken off.
    const int right = std::clamp(message.teams[team].max_robots, 1, all);
    if (present == right) {
      miscounts_[team] = 0;
    } else if (++miscounts_[team] > longest_miscount && miscount_.empty()) {
      miscount_ = std::string(world::name(team)) + " had " + std::to_string(present) +
                  " robots on the field where " + std::to_string(right) + " should be, for more than " +
                  std::to_string(longest_miscount) + " s of GAME_OFF";
    }
  }
}

std::string Vitals::complaint() const {
  if (!heard_) return "the referee was not heard: it gave no command";
  for (const world::Team team : world::both_teams) {
    const std::string who = world::name(team);
    if (!commanded_[team]) return who + " never told a robot to move";
    if (way_[team] < least_way) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), "no robot came further than %.2f m", way_[team]);
      return who + " did not move: " + text.data();
    }
  }
  if (!in_play_) return "the ball was never in play";
  return miscount_;
}

}  // namespace host
