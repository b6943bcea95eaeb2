#pragma once

#include <array>

#include "teams/reference/reception.h"
#include "teams/reference/zones.h"

namespace reference {

/// V(q) without P_reach over the grid of the partition; all of it new every 0.1 s, a sixth each tick, or
/// every 0.3 s while there is no hurry.
///
/// Both ways of attacking look at the same map, so they cost the same.
class ValueMap {
 public:
  struct Point {
    Vector2d position = Vector2d::Zero();  ///< [m]
    double value = 0;                      ///< 0: nobody may stand there
    double ball_time = 0;                  ///< [s] of the pass
  };

  void refresh(const kit::View& view, const kit::BallModel& model, const Partition& partition, bool hurry);
  /// All points at once.
  void compute(const kit::View& view, const kit::BallModel& model, const Partition& partition);

  const Point& at(int index) const { return points_[static_cast<std::size_t>(index)]; }

 private:
  void evaluate(const kit::View& view, const kit::BallModel& model, const Partition& partition, int index);

  std::array<Point, grid_points> points_{};
  bool begun_ = false;
};

/// A supporter may wait there: on the field, 0.2 m and its hull from their defense area.
bool may_wait_at(const kit::View& view, const Vector2d& point);

}  // namespace reference
