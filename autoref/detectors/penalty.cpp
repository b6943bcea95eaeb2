#include "autoref/detectors/penalty.h"

#include <cmath>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double tolerance = 0.03;  // [m]

}  // namespace

PenaltyOffenders penalty_offenders(const world::Field& field, double line, const world::TrackedFrame& frame,
                                   const world::GameState& state) {
  const world::Team defending = world::opponent(state.kick_team);
  const double sign = world::sign(world::defended_side(state, defending));
  const world::Vector2d mark(sign * (field.half_length() - field.penalty_mark_distance), 0);
  const world::TrackedRobot* kicker = nearest_robot(frame, mark, state.kick_team);

  PenaltyOffenders offenders;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (kicker != nullptr && robot.id == kicker->id) continue;
    const double depth = field.half_length() - sign * robot.position.x();  // [m] in front of the goal line
    bool fine = false;
    if (robot.id.team == defending && robot.id.number == state.keeper[defending]) {
      fine = std::abs(depth) <= field.robot_radius + tolerance &&
             std::abs(robot.position.y()) <= field.goal_width / 2 + tolerance;
    } else {
      fine = depth - field.robot_radius >= field.penalty_mark_distance + line - tolerance &&
             world::distance_outside_lines(field, robot.position) <= tolerance;
    }
    auto& offender = robot.id.team == defending ? offenders.defender : offenders.attacker;
    if (!fine && !offender) offender = robot.id;
  }
  return offenders;
}

}  // namespace detectors
