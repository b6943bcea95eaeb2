#pragma once

#include <array>

#include "sim/world/field.h"
#include "sim/world/geometry.h"

namespace reference {

using world::Vector2d;

/// A part of the field, its sides along the axes [m].
struct Region {
  double x_low = 0, x_high = 0, y_low = 0, y_high = 0;

  Vector2d center() const { return {0.5 * (x_low + x_high), 0.5 * (y_low + y_high)}; }
  bool contains(const Vector2d& p, double margin = 0) const {
    return p.x() >= x_low - margin && p.x() <= x_high + margin && p.y() >= y_low - margin &&
           p.y() <= y_high + margin;
  }
};

/// One of the nine zones of the attack.
struct Zone {
  int column = 0;  ///< 0 back, 1 middle, 2 front
  int row = 0;     ///< -1 right (-y), 0 centre, +1 left

  bool operator==(const Zone&) const = default;
};
constexpr int zone_count = 9;
constexpr int index_of(Zone zone) { return 3 * zone.column + zone.row + 1; }

constexpr int grid_per_zone = 5;              ///< points along each side of a zone
constexpr int grid_side = 3 * grid_per_zone;  ///< points along each side of the partition
constexpr int grid_points = grid_side * grid_side;

/// The attacking region in 3 x 3 zones: x from max(-1 m, anchor - 2 m) to 0.3 m before their goal line, rows
/// with borders at a third of the half width.
///
/// Source  reference "football", 2.10, feature Z. Outer rows end 0.25 m inside the touch
///         lines (2.6: field margin).
class Partition {
 public:
  Partition() = default;
  Partition(const world::Field& field, double anchor);

  Region region() const;
  Region cell(Zone zone) const;
  Zone zone_of(const Vector2d& point) const;  ///< the nearest one for a point outside
  Vector2d grid_point(int index) const;       ///< index in [0, grid_points)
  static Zone zone_of_grid_point(int index);

 private:
  double x_low_ = -1, column_ = 1.7;   // [m]
  double border_ = 1, y_high_ = 2.75;  // [m]
};

/// The ball's column, which anchors the partition: the middle of the sixth of the field the ball is in [m].
///
/// @param before  the anchor of the tick before: kept until the ball is 0.2 m beyond its column
double anchor_of(const world::Field& field, double ball_x, double before);

constexpr int most_supports = 4;
using ZoneList = std::array<Zone, most_supports>;

/// Where the supporters go, in order of importance, whatever the opponents do: a table for balls on the left,
/// mirrored for balls on the right.
///
/// @param ball  the zone of the ball
/// @param left  the side of the ball: y > 0; decides in the centre row too
ZoneList zones_for(Zone ball, bool left);

}  // namespace reference
