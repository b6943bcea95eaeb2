#include "autoref/detectors/interfered_placement.h"

#include "autoref/detectors/ball.h"

namespace detectors {

Events InterferedPlacement::update(const world::TrackedFrame& frame, const world::GameState& state) {
  Events events;
  const bool placing = is_stop(state) && state.reset_position;
  if (placing && !frame.ball) return {};  // a frame without ball says nothing
  const world::Vector2d ball = placing ? on_ground(*frame.ball) : world::Vector2d::Zero();
  const bool to_be_placed = placing && (ball - *state.reset_position).norm() > tolerance_;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.id.number > world::max_robot_number) continue;
    Watched& watched = watched_[robot.id.team][robot.id.number];
    const bool in_the_way =
        to_be_placed &&
        world::distance({ball, *state.reset_position}, robot.position) - field_.robot_radius < distance_;
    if (!in_the_way) {
      if (!placing || frame.ball->observed) watched.since.reset();
      continue;
    }
    if (!watched.since) watched.since = frame.time;
    if (watched.reported || frame.time - *watched.since < grace_) continue;
    watched.reported = true;
    events.push_back({frame.time, world::BotInterferedPlacement{robot.id, robot.position}});
  }
  return events;
}

}  // namespace detectors
