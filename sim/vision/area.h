#pragma once

#include <algorithm>

#include "sim/world/field.h"

namespace vision {

/// A rectangle on the ground, sides along the axes; may be infinite.
struct Area {
  double min_x, max_x, min_y, max_y;  ///< [m]

  bool contains(const world::Vector2d& point) const {
    return point.x() >= min_x && point.x() <= max_x && point.y() >= min_y && point.y() <= max_y;
  }
  /// The point at two shares, 0..1, of the sides.
  /// @pre the area is finite
  world::Vector2d at(double share_x, double share_y) const {
    return {min_x + share_x * (max_x - min_x), min_y + share_y * (max_y - min_y)};
  }
};

/// The part of an area inside the walls around the field.
inline Area inside_walls(const Area& area, const world::Field& field) {
  const double x = field.half_length() + field.boundary_width;
  const double y = field.half_width() + field.boundary_width;
  return {std::max(area.min_x, -x), std::min(area.max_x, x), std::max(area.min_y, -y),
          std::min(area.max_y, y)};
}

}  // namespace vision
