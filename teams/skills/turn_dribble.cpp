#include "teams/skills/turn_dribble.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "teams/skills/motion.h"
#include "teams/skills/steer.h"

namespace skills {
namespace {

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

// Rows by rising rate; between them linearly.
constexpr double degree = M_PI / 180;
constexpr std::array<TurnCircle, 4> table = {
    {{4, 0.07, 0}, {6, 0.07, -15 * degree}, {8, 0.07, -30 * degree}, {9, 0.07, -30 * degree}}};

}  // namespace

double fastest_turn() { return table.back().rate; }

TurnCircle turn_circle(double rate) {
  if (rate <= table.front().rate) return {rate, table.front().radius, table.front().phi};
  for (std::size_t i = 1; i < table.size(); ++i) {
    const TurnCircle& a = table[i - 1];
    const TurnCircle& b = table[i];
    if (rate > b.rate) continue;
    const double share = (rate - a.rate) / (b.rate - a.rate);
    return {rate, a.radius + share * (b.radius - a.radius), a.phi + share * (b.phi - a.phi)};
  }
  return table.back();
}

Vector2d carrying_velocity(const kit::Robot& robot, const TurnCircle& circle, double rate,
                           double ball_radius) {
  const double side = rate < 0 ? -1 : 1;
  const Vector2d ahead = world::direction(robot.orientation);
  // From the middle of the circle to the robot's centre; the middle lies ahead of the ball by sin(phi) and to
  // the side of the turn by cos(phi) of the radius.
  const double arm = robot.specs.center_to_dribbler + ball_radius;
  const Vector2d from_middle = -ahead * (arm + circle.radius * std::sin(circle.phi)) -
                               left_of(ahead) * (side * circle.radius * std::cos(circle.phi));
  return rate * left_of(from_middle);
}

Order turn_with_ball(const kit::View& view, const kit::Robot& robot, double heading, const TurnCircle& circle,
                     const Vector2d& drift) {
  Order order;
  order.why = "turn";
  order.dribble = true;
  order.robot_margin = 0.0;
  order.heading = heading;
  order.max_turn = circle.rate;
  const double rate = turning(robot, heading, circle.rate);
  order.velocity = carrying_velocity(robot, circle, rate, view.field().ball_radius) + drift;
  return order;
}

Order turn_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                    double kick_angle, double tolerance, double rate) {
  Order order = turn_with_ball(view, robot, direction, turn_circle(rate), shielding_drift(view, robot));
  const double error = std::abs(world::wrap_angle(direction - robot.orientation));
  if (error < tolerance && std::abs(robot.angular_velocity) < 3.0) {
    order.kick_speed = kick_speed;
    order.kick_angle = kick_angle;
  }
  return order;
}

double turn_time(const kit::Robot& robot, double angle, double rate) {
  Limits limits = turning_limits(robot.specs);
  limits.speed = std::min(limits.speed, rate);
  return time_to_rest(std::abs(angle), 0, limits);
}

Vector2d shielding_drift(const kit::View& view, const kit::Robot& robot) {
  constexpr double seen = 0.6;     // [m] centre to centre
  constexpr double fastest = 0.3;  // [m/s]
  double nearest = seen;
  Vector2d drift = Vector2d::Zero();
  for (const kit::Robot& other : view.opponents) {
    const Vector2d away = robot.position - other.position;
    const double distance = away.norm();
    if (distance >= nearest || distance < 1e-6) continue;
    nearest = distance;
    // Full at 0.3 m: hulls 0.12 m apart.
    drift = away / distance * (fastest * std::clamp((seen - distance) / 0.3, 0.0, 1.0));
  }
  return drift;
}

}  // namespace skills
