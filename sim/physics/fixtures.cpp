#include "sim/physics/fixtures.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using world::Vector2d;
using world::Vector3d;

constexpr double wall_thickness = 0.2;  // [m] ours, see the header
constexpr double wall_height = 3.0;     // [m] ours: a chip at 6 m/s rises 1.8 m
constexpr double side_thickness = 0.045;
constexpr double back_thickness = 0.060;

Fixture box(Fixture::Kind kind, const Vector3d& a, const Vector3d& b) {
  return {kind, a.cwiseMin(b), a.cwiseMax(b)};
}

}  // namespace

std::vector<Fixture> fixtures(const world::Field& field) {
  std::vector<Fixture> all;
  const double x = field.half_length() + field.boundary_width;
  const double y = field.half_width() + field.boundary_width;
  const double x_out = x + wall_thickness;
  const double y_out = y + wall_thickness;
  for (const double s : {-1.0, 1.0}) {
    all.push_back(box(Fixture::Kind::Wall, {s * x, -y_out, 0}, {s * x_out, y_out, wall_height}));
    all.push_back(box(Fixture::Kind::Wall, {-x_out, s * y, 0}, {x_out, s * y_out, wall_height}));
  }
  const double side = std::max(side_thickness, field.goal_wall);
  const double back = std::max(back_thickness, field.goal_wall);
  const double post = field.goal_width / 2;
  const double top = field.goal_height + field.goal_wall;
  for (const double s : {-1.0, 1.0}) {
    const double line = s * field.half_length();
    const double inside = s * (field.half_length() + field.goal_depth);
    const double outside = s * (field.half_length() + field.goal_depth + back);
    for (const double t : {-1.0, 1.0}) {
      all.push_back(box(Fixture::Kind::GoalSide, {line, t * post, 0}, {inside, t * (post + side), top}));
    }
    all.push_back(box(Fixture::Kind::GoalBack, {inside, -post - side, 0}, {outside, post + side, top}));
    all.push_back(box(Fixture::Kind::GoalRoof, {line, -post, field.goal_height}, {inside, post, top}));
  }
  return all;
}

double plane_distance(const Fixture& fixture, const Vector2d& point) {
  const Vector2d nearest = point.cwiseMax(fixture.min.head<2>()).cwiseMin(fixture.max.head<2>());
  return (point - nearest).norm();
}

}  // namespace physics
