#include "sim/physics/dribbler.h"

#include <algorithm>

namespace physics {

using world::Vector2d;
using world::Vector3d;

double grip(double dribbler_speed, const DribblerParams& params) {
  return std::clamp(dribbler_speed / params.full_speed, 0.0, 1.0);
}

Vector2d dribbler_push(const BallLocal& ball, const Vector2d& relative_velocity,
                       const world::RobotSpecs& specs, double grip, double ball_radius, double duration,
                       const DribblerParams& params) {
  const double pull = params.pull * grip * duration;
  const double drag = params.drag * grip * duration;
  const double gap = gap_to_front(ball, specs, ball_radius);
  const double wanted_x = -relative_velocity.x() - params.gain * gap;
  const double wanted_y = -relative_velocity.y() - params.gain * ball.position.y();
  return {std::clamp(wanted_x, -pull, 0.0), std::clamp(wanted_y, -drag, drag)};
}

Vector3d dribbled_spin(const Vector3d& spin, const Vector2d& forward, double dribbler_speed,
                       double ball_radius, double duration, const DribblerParams& params) {
  const double bar = std::clamp(dribbler_speed, 0.0, params.fastest_bar);
  const Vector3d left{-forward.y(), forward.x(), 0};
  const Vector3d change = left * (-bar * params.bar_radius / ball_radius) - spin;
  const double size = change.norm();
  const double most = params.spin_up * duration;
  return size <= most ? Vector3d(spin + change) : Vector3d(spin + change * (most / size));
}

}  // namespace physics
