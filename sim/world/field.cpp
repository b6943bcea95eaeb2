#include "sim/world/field.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

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

std::vector<Camera> camera_grid(const Field& field, int count, double height) {
  if (count != 1 && count != 2 && count != 4 && count != 6 && count != 8) {
    throw std::invalid_argument("cameras: 1, 2, 4, 6 or 8 are possible, not " + std::to_string(count));
  }
  if (!(std::isfinite(height) && height > 0)) {
    throw std::invalid_argument("camera height must be positive, is " + std::to_string(height));
  }
  const int rows = count <= 2 ? 1 : 2;
  const int columns = count / rows;
  const auto middle = [](double length, int part, int parts) {
    return length * (2 * part + 1 - parts) / (2 * parts);
  };
  std::vector<Camera> cameras;
  for (int column = 0; column < columns; ++column) {
    for (int row = 0; row < rows; ++row) {
      Camera& camera = cameras.emplace_back();
      camera.id = static_cast<int>(cameras.size()) - 1;
      camera.position = {middle(field.length, column, columns), middle(field.width, row, rows), height};
    }
  }
  return cameras;
}

std::vector<Camera> quarter_cameras(const Field& field, double height) {
  return camera_grid(field, 4, height);
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
    const Vector2d corner{area.depth, std::copysign(area.width / 2, p.y())};
    const double need_x = area.depth + distance - p.x();
    const double need_y = area.width / 2 + distance - std::abs(p.y());
    if (p.x() > area.depth && std::abs(p.y()) > area.width / 2) {
      p = corner + (p - corner).normalized() * distance;
    } else if (need_x <= need_y) {
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
