#pragma once

#include <array>
#include <optional>
#include <vector>

#include "autoref/detectors/robot_past.h"
#include "sim/world/field.h"
#include "sim/world/game_state.h"

namespace detectors {

/// Who certainly touched the ball in play near a defense area, and where that robot was then.
///
/// Touches that were reported as at least as probable as `sure`, and contact that lasts, which begins once
/// and is not reported again.
///
/// Carried  by one robot alone for four frames. Alone: no opponent within 30 mm, no team-mate within 12 mm,
///          since the goalie may stand beside a defender that offends.
/// Pressed  between two robots for two frames: hulls within 10 mm of the ball on opposite sides of it. Nobody
///          sees where between them it is, but in so narrow a gap it touches both.
/// Source   ours. A ball hidden for more than 0.6 s may be carried by anyone.
///          10 mm is twice the error of a hidden ball at a hull. The contact is dated to when the hull came
///          within 20 mm, at most 0.3 s back.
class AreaTouches {
 public:
  struct One {
    world::Touch touch;
    world::Vector2d robot;  ///< [m] its centre at the time of the touch; of contact that lasts: now
  };

  AreaTouches(const world::Field& field, double sure) : field_(field), sure_(sure) {}

  /// @return valid until the next call
  const std::vector<One>& update(const world::TrackedFrame& frame, const world::GameState& state);
  void reset() {
    past_.clear();
    carried_ = 0;
    near_ = {};
  }

 private:
  /// A robot in an area, near the ball.
  struct Near {
    std::optional<world::Time> since;
    int pressed = 0;  // frames in a row
  };

  std::optional<world::Touch> carried(const world::TrackedFrame& frame);
  std::optional<world::Touch> pressed(const world::TrackedFrame& frame, const world::TrackedRobot& robot,
                                      world::Time earliest);

  world::Field field_;
  double sure_;
  RobotPast past_;
  world::RobotId carrier_;
  int carried_ = 0;  // frames in a row
  world::PerTeam<std::array<Near, world::max_robot_number + 1>> near_{};
  std::vector<One> found_;
};

}  // namespace detectors
