#include "sim/physics/drive.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using world::Vector2d;

// Below this speed there is no direction to brake against [m/s]; ours: smaller than one substep's change.
constexpr double standstill = 1e-3;

// How long a vector is in units of the ellipse's radius in its direction.
double in_radii(const Vector2d& vector, const Vector2d& forward, double along, double across) {
  const Vector2d left{-forward.y(), forward.x()};
  return Vector2d(forward.dot(vector) / along, left.dot(vector) / across).norm();
}

// Radius of the ellipse in a direction. A circle, as robots have by default, is not computed.
double radius(const Vector2d& direction, const Vector2d& forward, double along, double across) {
  return along == across ? along : 1 / in_radii(direction, forward, along, across);
}

Vector2d within_speed(const Vector2d& wanted, const Vector2d& forward, const world::RobotSpecs& specs) {
  if (specs.max_speed == specs.max_speed_sideways) {
    const double squared = wanted.squaredNorm();
    if (squared <= specs.max_speed * specs.max_speed) return wanted;
    return wanted * (specs.max_speed / std::sqrt(squared));
  }
  return wanted / std::max(in_radii(wanted, forward, specs.max_speed, specs.max_speed_sideways), 1.0);
}

double acceleration_limit(const Vector2d& velocity, const Vector2d& towards, const Vector2d& forward,
                          const world::RobotSpecs& specs) {
  const double acceleration =
      radius(towards, forward, specs.max_acceleration, specs.max_acceleration_sideways);
  const double speed = velocity.norm();
  if (speed < standstill) return acceleration;
  const double along = towards.dot(velocity) / speed;
  if (along >= 0) return acceleration;
  const double brake = radius(towards, forward, specs.max_brake, specs.max_brake_sideways);
  const double across_squared = std::max(1 - along * along, 0.0);
  return 1 / std::sqrt(along * along / (brake * brake) + across_squared / (acceleration * acceleration));
}

}  // namespace

Motion driven(const Motion& now, const Motion& target, const Vector2d& forward,
              const world::RobotSpecs& specs, double duration) {
  Motion next;
  next.velocity = within_speed(target.velocity, forward, specs);
  const Vector2d change = next.velocity - now.velocity;
  const double size = change.norm();
  const double least = std::min(std::min(specs.max_acceleration, specs.max_brake),
                                std::min(specs.max_acceleration_sideways, specs.max_brake_sideways));
  if (size > least * duration) {
    const Vector2d towards = change / size;
    const double step = acceleration_limit(now.velocity, towards, forward, specs) * duration;
    if (size > step) next.velocity = now.velocity + towards * step;
  }

  const double turn_change =
      std::clamp(target.angular_velocity, -specs.max_angular_speed, specs.max_angular_speed) -
      now.angular_velocity;
  const bool slows = turn_change * now.angular_velocity < 0;
  const double turn_step = (slows ? specs.max_angular_brake : specs.max_angular_acceleration) * duration;
  next.angular_velocity = now.angular_velocity + std::clamp(turn_change, -turn_step, turn_step);
  return next;
}

}  // namespace physics
