#include "autoref/optics/hidden_ball.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/world/robot_specs.h"

namespace optics {
namespace {

constexpr world::RobotSpecs body{};
constexpr int steps = 12;  // along a shadow: half a millimetre at its longest

/// From a robot's outline to a point in its frame [m], negative inside, and the way out.
struct Beside {
  double distance;
  Vector2d normal;
};
Beside beside(const Vector2d& local, double radius) {
  const double half_front = std::sqrt(radius * radius - body.center_to_dribbler * body.center_to_dribbler);
  if (local.x() > 0 && std::abs(local.y()) * body.center_to_dribbler < local.x() * half_front) {
    if (std::abs(local.y()) < half_front) return {local.x() - body.center_to_dribbler, {1, 0}};
    const Vector2d corner(body.center_to_dribbler, std::copysign(half_front, local.y()));
    const Vector2d off = local - corner;
    const double far = off.norm();
    return {far, far > 0 ? Vector2d(off / far) : Vector2d(1, 0)};
  }
  const double far = local.norm();
  return {far - radius, far > 0 ? Vector2d(local / far) : Vector2d(1, 0)};
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

WholeBall HiddenBall::whole(const Vector2d& seen, const world::Detection& image) const {
  WholeBall ball{.position = seen};
  const auto camera = std::ranges::find(cameras_, image.camera, &world::Camera::id);
  if (camera == cameras_.end() || camera->position.z() <= 2 * body.height) return ball;
  const Vector2d foot = camera->position.head<2>();
  const double height = camera->position.z();
  const double radius = field_.ball_radius;
  // What is at the hull's top is seen so much farther from the camera's foot, at the height of the ball's
  // middle.
  const double longest = (height - radius) / (height - body.height) - 1;
  const double reach = field_.robot_radius + radius + longest * (seen - foot).norm() + 0.02;
  double least = radius;
  Vector2d out = Vector2d::Zero();
  for (const world::DetectedRobot& robot : image.robots) {
    if (!robot.orientation || (robot.position - seen).squaredNorm() > reach * reach) continue;
    const Vector2d shadow = (robot.position - foot) * longest;
    Beside nearest{1, {1, 0}};
    bool in_front = true;
    for (int n = 0; n <= steps; ++n) {
      const Vector2d local = world::rotated(seen - robot.position - shadow * n / steps, -*robot.orientation);
      const Beside here = beside(local, field_.robot_radius);
      if (here.distance >= nearest.distance) continue;
      nearest = here;
      in_front = n == 0;
    }
    const Vector2d local = world::rotated(seen - robot.position, -*robot.orientation);
    if (beside(local, field_.robot_radius).distance < 0) return ball;  // above the robot
    if (in_front || nearest.distance >= least) continue;
    least = nearest.distance;
    out = world::rotated(nearest.normal, *robot.orientation);
  }
  if (least >= radius) return ball;
  const double m = std::max(0.0, least / radius);
  const double u = uncovered(m);
  ball.shift = std::max(0.0, m - u) * radius;
  ball.position = seen - out * ball.shift;
  constexpr double step = 0.02;
  const double below = std::max(-1.0, u - step), above = std::min(1.0, u + step);
  ball.slope = 1 + (shift_of_visible(above) - shift_of_visible(below)) / (above - below);
  return ball;
}

}  // namespace optics
