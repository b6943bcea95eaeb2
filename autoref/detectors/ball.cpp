#include "autoref/detectors/ball.h"

#include <algorithm>
#include <cmath>

#include "sim/world/robot_specs.h"

namespace detectors {

using world::Vector2d;

double gap_to_ball(const world::Field& field, const world::TrackedRobot& robot, const Vector2d& ball) {
  static constexpr double front = world::RobotSpecs{}.center_to_dribbler;
  const Vector2d arm = ball - robot.position;
  const double disc = arm.norm() - field.robot_radius - field.ball_radius;
  if (disc > 0.3) return disc;  // [m] far away the front makes no difference
  const Vector2d local = world::rotated(arm, -robot.orientation);
  const double corner = std::sqrt(field.robot_radius * field.robot_radius - front * front);
  if (local.x() * corner < front * std::abs(local.y())) return disc;  // the round part is nearest
  const double ahead = local.x() - front;
  const double beside = std::max(0.0, std::abs(local.y()) - corner);
  return (ahead < 0 ? std::max(ahead, disc + field.ball_radius) : std::hypot(ahead, beside)) -
         field.ball_radius;
}

bool carries(const world::Field& field, const world::TrackedRobot& robot, const world::TrackedBall& ball) {
  constexpr double contact = 0.015;    // [m]
  constexpr double hidden = 0.025;     // [m] the tracker keeps a hidden ball where it vanished
  constexpr double same_speed = 0.3;   // [m/s]
  constexpr double least_speed = 0.1;  // [m/s] a ball at rest may be there without being touched
  if (ball.flight || !robot.ball_in_reach) return false;
  if (gap_to_ball(field, robot, on_ground(ball)) > (ball.observed ? contact : hidden)) return false;
  const Vector2d arm = on_ground(ball) - robot.position;
  const Vector2d carried = robot.velocity + robot.angular_velocity * Vector2d(-arm.y(), arm.x());
  const Vector2d velocity = ball.velocity.head<2>();
  return velocity.norm() > least_speed && (velocity - carried).norm() < same_speed;
}

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
  std::optional<world::RobotId> farthest;
  double most = 0;
  for (const world::TrackedRobot& robot : frame.robots) {
    const double own = robot.position.x() * world::sign(world::defended_side(state, robot.id.team));
    if (own >= most) continue;
    most = own;
    farthest = robot.id;
  }
  return farthest;
}

std::optional<world::Touch> last_touch(const world::TrackedFrame& frame, const world::GameState& state,
                                       world::Time time) {
  std::optional<world::Touch> last = state.last_touch;
  for (const world::Touch& touch : frame.touches) {
    if (touch.time <= time && (!last || touch.time >= last->time)) last = touch;
  }
  return last;
}

bool in_play(const world::Field& field, const world::GameState& state, const world::Touch& touch) {
  return touch.time >= state.location_time &&
         world::distance_outside_lines(field, touch.position) <= field.ball_radius;
}

double depth_in_area(const world::Field& field, world::Side side, const Vector2d& robot) {
  return field.robot_radius - world::distance_to_defense_area(field, side, robot);
}

std::optional<world::RobotId> keeper_with_ball(const world::Field& field, const world::TrackedFrame& frame,
                                               const world::GameState& state) {
  constexpr double at_hull = 0.015;
  constexpr double hidden = 0.03;  // the tracker's error of a hidden ball
  if (!frame.ball) return std::nullopt;
  const Vector2d ball = on_ground(*frame.ball);
  for (const world::Team team : world::both_teams) {
    const world::Side side = world::defended_side(state, team);
    if (world::distance_to_defense_area(field, side, ball) > 0) continue;
    const world::RobotId id{team, static_cast<std::uint8_t>(state.keeper[team])};
    const world::TrackedRobot* keeper = find_robot(frame, id);
    if (!keeper) continue;
    if (gap_to_ball(field, *keeper, ball) < (frame.ball->observed ? at_hull : hidden)) return id;
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
