#include "autoref/detectors/too_near_in_stop.h"

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double at_rest = 0.05;  // [m]

}  // namespace

Events TooNearInStop::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto ball = observed_ball(frame);
  if (is_stop(state) && !ball) return {};  // a frame without ball says nothing
  if (!is_stop(state) || !lies_at_ || (*ball - *lies_at_).norm() > at_rest) {
    for (const world::Team team : world::both_teams) {
      for (Watched& watched : watched_[team]) watched.since.reset();
    }
    lies_at_ = ball;
    return {};
  }
  Events events;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    Watched& watched = watched_[robot.id.team][robot.id.number];
    const double distance = hull_distance(field_, robot, *ball);
    if (distance >= distance_) {
      watched.since.reset();
      continue;
    }
    if (!watched.since) watched.since = frame.time;
    if (watched.reported || frame.time - *watched.since < grace_) continue;
    watched.reported = true;
    events.push_back({frame.time, world::BotTooNearInStop{robot.id, robot.position, distance}});
  }
  return events;
}

}  // namespace detectors
