#include "sim/world/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace world {

double wrap_angle(double angle) {
  constexpr double pi = std::numbers::pi;
  if (angle > -pi && angle <= pi) return angle;
  const double wrapped = std::remainder(angle, 2 * pi);  // in [-pi, pi]
  return wrapped <= -pi ? pi : wrapped;
}

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

double angle_of(const Vector2d& vector) { return std::atan2(vector.y(), vector.x()); }

Vector2d rotated(const Vector2d& vector, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * vector.x() - s * vector.y(), s * vector.x() + c * vector.y()};
}

Vector2d closest_point(const Segment& segment, const Vector2d& point) {
  const Vector2d along = segment.to - segment.from;
  const double length_squared = along.squaredNorm();
  if (length_squared == 0) return segment.from;
  const double fraction = std::clamp((point - segment.from).dot(along) / length_squared, 0.0, 1.0);
  return segment.from + fraction * along;
}

double distance(const Segment& segment, const Vector2d& point) {
  return (point - closest_point(segment, point)).norm();
}

std::optional<Vector2d> line_intersection(const Segment& a, const Segment& b) {
  const Vector2d u = a.to - a.from;
  const Vector2d v = b.to - b.from;
  const double cross = u.x() * v.y() - u.y() * v.x();
  if (std::abs(cross) <= 1e-12 * u.norm() * v.norm()) return std::nullopt;
  const Vector2d w = b.from - a.from;
  return a.from + u * ((w.x() * v.y() - w.y() * v.x()) / cross);
}

}  // namespace world
