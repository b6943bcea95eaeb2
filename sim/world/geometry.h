#pragma once

#include <Eigen/Core>
#include <optional>

namespace world {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The same angle in (-pi, pi].
double wrap_angle(double angle);

/// Unit vector at an angle [rad], counter-clockwise from x.
Vector2d direction(double angle);

/// Angle of a vector, counter-clockwise from x [rad]; 0 for the null vector.
double angle_of(const Vector2d& vector);

/// The vector turned by an angle [rad], counter-clockwise.
Vector2d rotated(const Vector2d& vector, double angle);

struct Segment {
  Vector2d from = Vector2d::Zero();
  Vector2d to = Vector2d::Zero();
};

/// The point of the segment nearest to `point`.
Vector2d closest_point(const Segment& segment, const Vector2d& point);

double distance(const Segment& segment, const Vector2d& point);

/// Where two lines (extended without end) meet; nothing when they are parallel.
std::optional<Vector2d> line_intersection(const Segment& a, const Segment& b);

}  // namespace world
