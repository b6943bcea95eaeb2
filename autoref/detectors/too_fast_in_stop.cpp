#include "autoref/detectors/too_fast_in_stop.h"

#include "autoref/detectors/ball.h"

namespace detectors {

Events TooFastInStop::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (!is_stop(state) || frame.time - state.command_time < grace_) return {};
  Events events;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    Watched& watched = watched_[robot.id.team][robot.id.number];
    const double speed = robot.velocity.norm();
    if (!robot.observed || speed <= limit_) {
      watched.since.reset();
      continue;
    }
    if (!watched.since) watched.since = frame.time;
    if (watched.reported || frame.time - *watched.since < violation_) continue;
    watched.reported = true;
    events.push_back({frame.time, world::BotTooFastInStop{robot.id, robot.position, speed}});
  }
  return events;
}

}  // namespace detectors
