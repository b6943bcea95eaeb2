#include "autoref/optics/partly_hidden.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/world/robot_specs.h"

namespace optics {
namespace {

constexpr world::RobotSpecs body{};
constexpr int steps = 12;           // along a shadow: a centimetre each at its longest
constexpr double slack = 0.02;      // [m] of a robot's place
constexpr double least_seen = 0.3;  // radii from the edge: less than a third of it is not reported as a ball

/// From a robot's outline to a point in its frame [m], negative inside, and the way out.
struct Beside {
  double distance;
  Vector2d normal;
};
Beside from_outline(const Vector2d& local, double radius) {
  const double half_front = std::sqrt(radius * radius - body.center_to_dribbler * body.center_to_dribbler);
  const double far = local.norm();
  const Vector2d outwards = far > 0 ? Vector2d(local / far) : Vector2d(1, 0);
  if (local.x() * half_front <= std::abs(local.y()) * body.center_to_dribbler)
    return {far - radius, outwards};
  if (std::abs(local.y()) < half_front) return {local.x() - body.center_to_dribbler, {1, 0}};
  const Vector2d off = local - Vector2d(body.center_to_dribbler, std::copysign(half_front, local.y()));
  const double from_corner = off.norm();
  return {from_corner, from_corner > 0 ? Vector2d(off / from_corner) : outwards};
}

}  // namespace

double shift_of_visible(double u) {
  u = std::clamp(u, -1.0, 1.0);
  const double half_chord = std::sqrt(std::max(0.0, 1 - u * u));
  const double visible = std::numbers::pi - std::acos(u) + u * half_chord;
  if (visible < 1e-9) return 1;
  return 2.0 / 3 * half_chord * half_chord * half_chord / visible;
}

double uncovered(double m) {
  double low = -1, high = 1;
  for (int n = 0; n < 20; ++n) {
    const double u = (low + high) / 2;
    (u + shift_of_visible(u) < m ? low : high) = u;
  }
  return (low + high) / 2;
}

PartlyHidden::PartlyHidden(const world::Field& field, const world::Camera& camera, const Vector2d& seen)
    : field_(field), seen_(seen), foot_(camera.position.head<2>()), least_(field.ball_radius) {
  // What is at the hull's top is seen so much farther from the camera's foot,
  // at the height of the ball's middle.
  const double height = camera.position.z();
  const bool high = height > 2 * body.height;
  stretch_ = high ? (body.height - field.ball_radius) / (height - body.height) : 0;
  reach_ = high ? (field.robot_radius + field.ball_radius + stretch_ * (seen - foot_).norm() + slack) : 0;
}

void PartlyHidden::beside(const Vector2d& robot, double orientation) {
  if ((robot - seen_).squaredNorm() > reach_ * reach_) return;
  const Vector2d local = world::rotated(seen_ - robot, -orientation);
  Beside nearest = from_outline(local, field_.robot_radius);
  if (nearest.distance < 0) {
    above_ = true;
    return;
  }
  const Vector2d shadow = world::rotated((robot - foot_) * stretch_, -orientation);
  bool behind = false;
  for (int n = 1; n <= steps; ++n) {
    const Beside here = from_outline(local - shadow * n / steps, field_.robot_radius);
    if (here.distance >= nearest.distance) continue;
    nearest = here;
    behind = true;
  }
  if (!behind || nearest.distance >= least_) return;
  least_ = nearest.distance;
  out_ = world::rotated(nearest.normal, orientation);
}

WholeBall PartlyHidden::whole() const {
  WholeBall ball{.position = seen_};
  const double radius = field_.ball_radius;
  if (above_ || least_ >= radius) return ball;  // in the air over a robot, or in full view
  const double m = std::max(least_seen, least_ / radius);
  const double u = uncovered(m);
  ball.shift = (m - u) * radius;
  ball.position = seen_ - out_ * ball.shift;
  constexpr double step = 0.02;
  const double below = std::max(-1.0, u - step), above = std::min(1.0, u + step);
  ball.slope = 1 + (shift_of_visible(above) - shift_of_visible(below)) / (above - below);
  return ball;
}

}  // namespace optics
