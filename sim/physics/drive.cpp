#include "sim/physics/drive.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using world::Vector2d;

// Below this speed there is no direction to brake against [m/s]; ours: smaller than one substep's change.
constexpr double standstill = 1e-3;

double acceleration_limit(const Vector2d& velocity, const Vector2d& change_direction,
                          const world::RobotSpecs& specs) {
  const double speed = velocity.norm();
  if (speed < standstill) return specs.max_acceleration;
  const double along = change_direction.dot(velocity) / speed;
  if (along >= 0) return specs.max_acceleration;
  const double across_squared = std::max(1 - along * along, 0.0);
  return 1 / std::sqrt(along * along / (specs.max_brake * specs.max_brake) +
                       across_squared / (specs.max_acceleration * specs.max_acceleration));
}

}  // namespace

Motion driven(const Motion& now, const Motion& target, const world::RobotSpecs& specs, double duration) {
  Vector2d wanted = target.velocity;
  const double wanted_squared = wanted.squaredNorm();
  if (wanted_squared > specs.max_speed * specs.max_speed)
    wanted *= specs.max_speed / std::sqrt(wanted_squared);

  Motion next;
  next.velocity = wanted;
  const Vector2d change = wanted - now.velocity;
  const double size = change.norm();
  if (size > std::min(specs.max_acceleration, specs.max_brake) * duration) {
    const Vector2d towards = change / size;
    const double step = acceleration_limit(now.velocity, towards, specs) * duration;
    if (size > step) next.velocity = now.velocity + towards * step;
  }

  const double wanted_turn =
      std::clamp(target.angular_velocity, -specs.max_angular_speed, specs.max_angular_speed);
  const double turn_step = specs.max_angular_acceleration * duration;
  next.angular_velocity =
      now.angular_velocity + std::clamp(wanted_turn - now.angular_velocity, -turn_step, turn_step);
  return next;
}

}  // namespace physics
