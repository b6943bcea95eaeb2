#include "sim/physics/hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace physics {

using world::Vector2d;

double hull_distance_local(const world::RobotSpecs& specs, const Vector2d& point) {
  const double front = specs.center_to_dribbler;
  const double half_front = std::sqrt(std::max(specs.radius * specs.radius - front * front, 0.0));
  const double round = point.norm() - specs.radius;
  if (point.x() <= front) return std::max(round, point.x() - front);
  if (std::abs(point.y()) <= half_front) return point.x() - front;
  // Beside the front: the nearest place is on the round part unless that part has been cut off there.
  if (point.x() * specs.radius <= front * point.norm()) return round;
  return std::hypot(point.x() - front, std::abs(point.y()) - half_front);
}

double hull_distance(const world::RobotSpecs& specs, const Vector2d& position, double orientation,
                     const Vector2d& point) {
  return hull_distance_local(specs, world::rotated(point - position, -orientation));
}

std::vector<Vector2d> hull_corners(const world::RobotSpecs& specs, int segments, double inset) {
  const double radius = specs.radius - inset;
  const double front = specs.center_to_dribbler - inset;
  const double edge = std::acos(std::clamp(front / radius, -1.0, 1.0));
  const double piece = 2 * (std::numbers::pi - edge) / segments;
  // The first and last corner stay on the front's ends; the others are moved out by half the sagitta.
  const double outer = 2 * radius / (1 + std::cos(piece / 2));
  std::vector<Vector2d> corners;
  for (int i = 0; i <= segments; ++i) {
    const double r = i == 0 || i == segments ? radius : outer;
    corners.push_back(world::direction(edge + i * piece) * r);
  }
  return corners;
}

}  // namespace physics
