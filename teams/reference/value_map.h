#pragma once

#include <array>

#include "teams/reference/reception.h"
#include "teams/reference/zones.h"

namespace reference {

/// V(q) without P_reach over the grid of the partition; all of it new every 0.2 s, a twelfth each tick, or
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
  Vector2d position(int index) const { return known_as_far_as(Known::Bound, index).position; }  ///< [m]
  /// At least the value there, cheaply: what it would be if the pass were safe and the goal open.
  double most(int index) const { return known_as_far_as(Known::Bound, index).value; }
  /// The same with the pass as it is: its time is right, the value at least what it will be.
  const Point& pass(int index) const { return known_as_far_as(Known::Pass, index); }

 private:
  /// What the points of one tick are worked out from.
  struct Moment {
    kit::View view;
    kit::BallModel model;
    Partition partition;
  };
  enum class Known : std::uint8_t { Nothing, Bound, Pass, Value };
  struct Entry {
    Point point;      // as far as it is known
    Reception least;  // likewise
    double open = 0;  // P_goal if nobody stood before the goal
  };

  void remember(const kit::View& view, const kit::BallModel& model, const Partition& partition);
  const Point& known_as_far_as(Known wanted, int index) const {
    const auto i = static_cast<std::size_t>(index);
    if (known_[i] < wanted) find_out(wanted, i);
    return entries_[i].point;
  }
  void find_out(Known wanted, std::size_t index) const;
  void forget(std::size_t index) {
    known_[index] = Known::Nothing;
    moment_of_[index] = now_;
  }

  std::array<Moment, 20> moments_;  // more than a slow round has ticks
  std::uint8_t now_ = 0;
  // Apart from the entries: looked through in every tick.
  mutable std::array<Known, grid_points> known_{};
  std::array<std::uint8_t, grid_points> moment_of_{};
  mutable std::array<Entry, grid_points> entries_{};
  bool begun_ = false;
};

/// A supporter may wait there: on the field, 0.2 m and its hull from their defense area.
bool may_wait_at(const kit::View& view, const Vector2d& point);

}  // namespace reference
