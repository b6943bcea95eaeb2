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
                                        const Vector2d& carried) {
  if (!(command.kick_speed > 0)) return std::nullopt;
  const double angle = std::clamp(command.kick_angle, 0.0, params.steepest);
  const double speed = std::min(command.kick_speed, angle > 0 ? specs.max_chip_speed : specs.max_kick_speed);
  const Vector2d left{-forward.y(), forward.x()};
  const Vector2d flat = forward * (speed * std::cos(angle)) + left * left.dot(carried);
  const Vector3d velocity{flat.x(), flat.y(), speed * std::sin(angle)};
  return Vector3d(velocity * (speed / velocity.norm()));
}

}  // namespace physics
