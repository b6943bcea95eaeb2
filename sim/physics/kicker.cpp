#include "sim/physics/kicker.h"

#include <algorithm>
#include <cmath>

namespace physics {

using world::Vector2d;
using world::Vector3d;

double gap_to_front(const BallLocal& ball, const world::RobotSpecs& specs, double ball_radius) {
  return ball.position.x() - specs.center_to_dribbler - ball_radius;
}

bool in_front(const BallLocal& ball, const world::RobotSpecs& specs, double ball_radius, double reach,
              double highest) {
  const double gap = gap_to_front(ball, specs, ball_radius);
  return gap <= reach && gap >= -ball_radius && std::abs(ball.position.y()) <= specs.dribbler_width / 2 &&
         ball.height <= highest;
}

std::optional<Vector3d> kicked_velocity(const world::RobotCommand& command, const world::RobotSpecs& specs,
                                        const KickerParams& params, const Vector2d& forward,
                                        const Vector2d& carried, const KickError& error) {
  if (!(command.kick_speed > 0)) return std::nullopt;
  const bool chips = command.kick_angle > 0;
  const double angle = chips ? std::clamp(command.kick_angle + error.chip_angle, 0.0, params.steepest) : 0;
  const double cap = chips ? specs.max_chip_speed : specs.max_kick_speed;
  const double speed = std::min(std::min(command.kick_speed, cap) * error.speed_factor, cap);
  const Vector2d aim = error.direction == 0 ? forward : world::rotated(forward, error.direction);
  const Vector2d left{-aim.y(), aim.x()};
  const Vector2d flat = aim * (speed * std::cos(angle)) + left * left.dot(carried);
  const Vector3d velocity{flat.x(), flat.y(), speed * std::sin(angle)};
  return Vector3d(velocity * (speed / velocity.norm()));
}

}  // namespace physics
