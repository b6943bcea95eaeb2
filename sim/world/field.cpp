#include "sim/world/field.h"

#include <algorithm>
#include <cmath>

namespace world {
namespace {

// The same place seen with the goal's centre as origin and x pointing into the field.
Vector2d from_goal(const Field& field, Side side, const Vector2d& point) {
  return {field.half_length() - sign(side) * point.x(), point.y()};
}

Vector2d to_field(const Field& field, Side side, const Vector2d& point) {
  return {sign(side) * (field.half_length() - point.x()), point.y()};
}

}  // namespace

std::vector<Camera> quarter_cameras(const Field& field, double height) {
  std::vector<Camera> cameras;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      const int id = static_cast<int>(cameras.size());
      cameras.push_back({id, {x * field.length / 4, y * field.width / 4, height}});
    }
  }
  return cameras;
}

Vector2d goal_center(const Field& field, Side side) { return {sign(side) * field.half_length(), 0}; }

double distance_to_defense_area(const Field& field, Side side, const Vector2d& point) {
  const DefenseArea& area = field.defense_area;
  const Vector2d p = from_goal(field, side, point);
  if (area.shape == DefenseArea::Shape::QuarterCircles) {
    const double beside = std::max(std::abs(p.y()) - area.stretch / 2, 0.0);
    return std::hypot(std::max(p.x(), 0.0), beside) - area.radius;
  }
  const double dx = p.x() - area.depth;
  const double dy = std::abs(p.y()) - area.width / 2;
  if (dx <= 0 && dy <= 0) return std::max(dx, dy);
  return std::hypot(std::max(dx, 0.0), std::max(dy, 0.0));
}

Vector2d moved_out_of_defense_area(const Field& field, Side side, const Vector2d& point, double distance) {
  const double now = distance_to_defense_area(field, side, point);
  if (now >= distance) return point;
  const DefenseArea& area = field.defense_area;
  Vector2d p = from_goal(field, side, point);
  if (area.shape == DefenseArea::Shape::QuarterCircles) {
    const double corner = std::clamp(p.y(), -area.stretch / 2, area.stretch / 2);
    const Vector2d centre{0, corner};
    Vector2d out = p - centre;
    out.x() = std::max(out.x(), 0.0);
    if (out.norm() < 1e-9) out = {1, 0};
    p = centre + out.normalized() * (area.radius + distance);
  } else {
    const double need_x = area.depth + distance - p.x();
    const double need_y = area.width / 2 + distance - std::abs(p.y());
    if (need_x <= need_y) {
      p.x() += need_x;
    } else {
      p.y() += std::copysign(need_y, p.y());
    }
  }
  return to_field(field, side, p);
}

double distance_outside_lines(const Field& field, const Vector2d& point) {
  return std::max(std::abs(point.x()) - field.half_length(), std::abs(point.y()) - field.half_width());
}

}  // namespace world
