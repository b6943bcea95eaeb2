#pragma once

#include <array>

#include "teams/reference/reception.h"
#include "teams/reference/zones.h"

namespace reference {

/// V(q) without P_reach over the grid of the partition; all of it new every 0.1 s, a sixth each tick, or
/// every 0.3 s while there is no hurry.
///
/// Both ways of attacking look at the same map. A point is worked out when it is first asked for, from the
/// world as it was in its tick: the values are those of a map worked out at once, but most are never needed.
class ValueMap {
 public:
  struct Point {
    Vector2d position = Vector2d::Zero();  ///< [m]
    double value = 0;                      ///< 0: nobody may stand there
    double ball_time = 0;                  ///< [s] of the pass
  };

  void refresh(const kit::View& view, const kit::BallModel& model, const Partition& partition, bool hurry);
  /// All points of this tick.
  void compute(const kit::View& view, const kit::BallModel& model, const Partition& partition);

  const Point& at(int index) const;
  Vector2d position(int index) const;  ///< without the value [m]
  /// At least the value there, cheaply: what it would be if the pass were safe and the goal open.
  double most(int index) const;

 private:
  /// What the points of one tick are worked out from.
  struct Moment {
    kit::View view;
    kit::BallModel model;
    Partition partition;
  };
  static constexpr int known = -1;

  void remember(const kit::View& view, const kit::BallModel& model, const Partition& partition);
  void evaluate(int index) const;
  const Moment& moment_of(int index) const;

  std::array<Moment, 20> moments_;  // more than a slow round has ticks
  int now_ = 0;
  mutable std::array<Point, grid_points> points_{};
  mutable std::array<std::int8_t, grid_points> waits_for_{};  // the moment, or `known`
  bool begun_ = false;
};

/// A supporter may wait there: on the field, 0.2 m and its hull from their defense area.
bool may_wait_at(const kit::View& view, const Vector2d& point);

}  // namespace reference
