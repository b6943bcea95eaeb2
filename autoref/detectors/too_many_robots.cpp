#include "autoref/detectors/too_many_robots.h"

#include <chrono>

namespace detectors {
namespace {

// A robot unseen for longer was away (ours: bursts of losses are shorter).
constexpr world::Duration gap = std::chrono::milliseconds{500};

}  // namespace

Events TooManyRobots::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (!allowed_) {
    allowed_.emplace();
    for (const world::Team team : world::both_teams) {
      (*allowed_)[team] = most_ - state.red_cards[team] - static_cast<int>(state.yellow_times[team].size());
    }
  }
  for (const world::TrackedRobot& robot : frame.robots) {
    if (!robot.observed || robot.id.number > world::max_robot_number) continue;
    Known& known = known_[robot.id.team][robot.id.number];
    if (!known.since || frame.time - known.last > gap) known.since = frame.time;
    known.last = frame.time;
  }
  Events events;
  for (const world::Team team : world::both_teams) {
    int robots = 0;
    for (const Known& known : known_[team]) {
      if (known.since && frame.time - known.last <= gap && frame.time - *known.since >= time_) ++robots;
    }
    if (reported_[team] || robots <= (*allowed_)[team]) continue;
    reported_[team] = true;
    events.push_back({frame.time, world::TooManyRobots{team, robots, (*allowed_)[team]}});
  }
  return events;
}

}  // namespace detectors
