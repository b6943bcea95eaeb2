#include "autoref/detectors/ball.h"

#include <algorithm>
#include <cmath>

namespace detectors {

using world::Vector2d;

const world::TrackedRobot* nearest_robot(const world::TrackedFrame& frame, const Vector2d& point,
                                         std::optional<world::Team> team) {
  const world::TrackedRobot* nearest = nullptr;
  double least = 0;
  for (const world::TrackedRobot& robot : frame.robots) {
    if (team && robot.id.team != *team) continue;
    const double distance = (robot.position - point).squaredNorm();
    if (!nearest || distance < least) {
      nearest = &robot;
      least = distance;
    }
  }
  return nearest;
}

std::optional<world::RobotId> robot_in_wrong_half(const world::TrackedFrame& frame,
                                                  const world::GameState& state) {
  for (const world::TrackedRobot& robot : frame.robots) {
    if (robot.position.x() * world::sign(world::defended_side(state, robot.id.team)) < 0) return robot.id;
  }
  return std::nullopt;
}

bool plausible_step(const Vector2d& from, const Vector2d& to, world::Duration between) {
  constexpr double fastest = 12.0;
  constexpr double slack = 0.1;
  return (to - from).norm() <= fastest * world::seconds(between) + slack;
}

bool in_goal(const world::Field& field, const Vector2d& ball, double margin) {
  const double behind = std::abs(ball.x()) - field.half_length();
  return behind > 0 && behind < field.goal_depth + margin && std::abs(ball.y()) < field.goal_width / 2;
}

Crossing crossing(const world::Field& field, const Vector2d& from, const Vector2d& to) {
  // The whole ball is out when its centre is one radius outside the line's outer edge.
  const double length = field.half_length() + field.ball_radius;
  const double width = field.half_width() + field.ball_radius;

  Crossing result;
  const bool began_inside = std::abs(from.x()) <= length && std::abs(from.y()) <= width;
  if (began_inside) {
    // Fraction of the way at which each line is passed; above 1 when it is not.
    const Vector2d way = to - from;
    double over_goal_line = 2;
    double over_touch_line = 2;
    if (std::abs(to.x()) > length) over_goal_line = (std::copysign(length, to.x()) - from.x()) / way.x();
    if (std::abs(to.y()) > width) over_touch_line = (std::copysign(width, to.y()) - from.y()) / way.y();
    result.goal_line = over_goal_line <= over_touch_line;
    result.point = from + way * std::min({over_goal_line, over_touch_line, 1.0});
  } else {
    result.goal_line = std::abs(to.x()) - length >= std::abs(to.y()) - width;
    result.point = {std::clamp(to.x(), -length, length), std::clamp(to.y(), -width, width)};
  }
  result.in_mouth = result.goal_line && std::abs(result.point.y()) < field.goal_width / 2;
  return result;
}

}  // namespace detectors
