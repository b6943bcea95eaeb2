#include "teams/reference/zones.h"

#include <algorithm>
#include <cmath>

namespace reference {
namespace {

// Of the ball's side ("near"), of the other ("far").
constexpr int near = 1, centre = 0, far = -1;
constexpr int back = 0, mid = 1, front = 2;

// Rows of the table: column of the ball, then centre or wing. The first zones are for the pass that may
// become a shot, the later ones keep the ball. The wing of the middle column is the example of the reference
// "football", 2.10; the others are ours.
constexpr ZoneList table[3][2] = {
    {{{{mid, near}, {mid, far}, {back, far}, {front, centre}}},
     {{{mid, near}, {back, centre}, {mid, far}, {front, centre}}}},
    {{{{front, far}, {front, near}, {mid, far}, {back, centre}}},
     {{{front, far}, {front, centre}, {front, near}, {back, centre}}}},
    {{{{front, far}, {front, near}, {mid, centre}, {back, far}}},
     {{{front, far}, {mid, centre}, {mid, near}, {back, centre}}}},
};

}  // namespace

Partition::Partition(const world::Field& field, double anchor) {
  const double x_high = field.half_length() - 0.3;
  x_low_ = std::max(-1.0, anchor - 2.0);
  column_ = (x_high - x_low_) / 3;
  border_ = field.half_width() / 3;
  y_high_ = field.half_width() - 0.25;
}

Region Partition::region() const { return {x_low_, x_low_ + 3 * column_, -y_high_, y_high_}; }

Region Partition::cell(Zone zone) const {
  Region cell;
  cell.x_low = x_low_ + zone.column * column_;
  cell.x_high = cell.x_low + column_;
  cell.y_low = zone.row < 0 ? -y_high_ : zone.row == 0 ? -border_ : border_;
  cell.y_high = zone.row < 0 ? -border_ : zone.row == 0 ? border_ : y_high_;
  return cell;
}

Zone Partition::zone_of(const Vector2d& point) const {
  Zone zone;
  zone.column = static_cast<int>(std::clamp(std::floor((point.x() - x_low_) / column_), 0.0, 2.0));
  zone.row = point.y() > border_ ? 1 : point.y() < -border_ ? -1 : 0;
  return zone;
}

Zone Partition::zone_of_grid_point(int index) {
  return {index / grid_side / grid_per_zone, index % grid_side / grid_per_zone - 1};
}

Vector2d Partition::grid_point(int index) const {
  const Region in = cell(zone_of_grid_point(index));
  const int i = index / grid_side % grid_per_zone, j = index % grid_side % grid_per_zone;
  return {in.x_low + (in.x_high - in.x_low) * (i + 0.5) / grid_per_zone,
          in.y_low + (in.y_high - in.y_low) * (j + 0.5) / grid_per_zone};
}

double anchor_of(const world::Field& field, double ball_x, double before) {
  const double width = field.length / 6;
  if (std::abs(ball_x - before) < width / 2 + 0.2) return before;
  const double column = std::clamp(std::floor(ball_x / width), -3.0, 2.0);
  return (column + 0.5) * width;
}

ZoneList zones_for(Zone ball, bool left) {
  ZoneList list = table[ball.column][ball.row != 0];
  if (!left) {
    for (Zone& zone : list) zone.row = -zone.row;
  }
  return list;
}

}  // namespace reference
