#include "autoref/detectors/robot_left_field.h"

namespace detectors {
namespace {

// [m] Inside the limit by less, a robot has not come back: twice what two cameras disagree by (ours).
constexpr double back = 0.08;

}  // namespace

Events RobotLeftField::update(const world::TrackedFrame& frame, const world::GameState&) {
  Events events;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number || !robot.observed) continue;
    Watched& watched = watched_[robot.id.team][robot.id.number];
    const double outside = world::distance_outside_lines(field_, robot.position);
    if (outside <= run_off_) watched.since.reset();
    if (outside <= run_off_ - back) watched.reported = false;
    if (outside <= run_off_) continue;
    if (!watched.since) watched.since = frame.time;
    if (watched.reported || frame.time - *watched.since < time_) continue;
    watched.reported = true;
    events.push_back({frame.time, world::BotLeftField{robot.id, robot.position, outside}});
  }
  return events;
}

}  // namespace detectors
