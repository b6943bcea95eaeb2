#include "experiments/host/vitals.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace host {

void Vitals::note(const world::PerTeam<world::TeamCommands>& commands, const world::GameState& state) {
  in_play_ = in_play_ || state.location == world::Location::GameOn;
  for (const world::Team team : world::both_teams) {
    if (commanded_[team]) continue;
    const world::TeamCommands& its = commands[team];
    commanded_[team] = std::any_of(its.begin(), its.end(), [](const world::RobotCommand& command) {
      return !command.velocity_local.isZero(0) || command.angular_velocity != 0;
    });
  }
}

void Vitals::add(const truth::Frame& truth, const world::RefereeMessage& message,
                 const world::GameState& state) {
  if (first_.empty()) {
    first_ = truth.robots;
    first_command_ = message.command_counter;
  }
  heard_ = heard_ || message.command_counter != first_command_;
  const world::CommandKind kind = message.command.kind;
  started_ = started_ || in_play_ || kind == world::CommandKind::Ready || kind == world::CommandKind::Start;

  for (const truth::Robot& robot : truth.robots) {
    const auto first = std::find_if(first_.begin(), first_.end(),
                                    [&](const truth::Robot& other) { return other.id == robot.id; });
    if (first == first_.end()) continue;
    double& way = way_[robot.id.team];
    way = std::max(way, (robot.position - first->position).norm());
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

// What it commanded does not excuse a team whose robots stay: a millionth of a metre a second, turns on the
// spot or two robots that push each other are commands, too.
std::string Vitals::stillness(world::Team team) const {
  if (!commanded_[team]) return "never told a robot to move";
  if (way_[team] >= least_way) return "";
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "did not move: no robot came further than %.2f m", way_[team]);
  return text.data();
}

Vitals::Complaint Vitals::complaint() const {
  if (!heard_) return {"the referee was not heard: it gave no command", {}};
  const std::string yellow = stillness(world::Team::Yellow);
  const std::string blue = stillness(world::Team::Blue);
  if (!yellow.empty() && !blue.empty()) return {"yellow " + yellow + ", and blue " + blue, {}};
  if (!miscount_.empty()) return {miscount_, {}};
  if (started_ && !yellow.empty()) return {yellow, world::Team::Yellow};
  if (started_ && !blue.empty()) return {blue, world::Team::Blue};
  if (!in_play_) return {"the ball was never in play", {}};
  return {};
}

}  // namespace host
