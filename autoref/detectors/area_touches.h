#pragma once

#include <vector>

#include "autoref/detectors/robot_past.h"
#include "sim/world/field.h"
#include "sim/world/game_state.h"

namespace detectors {

/// Who certainly touched the ball in play near a defense area, and where that robot was then.
///
/// Touches that were reported as at least as probable as `sure`, and a ball that one robot alone has carried
/// for four frames: such contact begins once and is not reported again. Alone: no opponent within 30 mm, no
/// team-mate within 12 mm, since the goalie stands beside a defender that offends.
/// Source  ours; a ball hidden for more than 0.6 s may be anyone's.
class AreaTouches {
 public:
  struct One {
    world::Touch touch;
    world::Vector2d robot;  ///< [m] its centre at the time of the touch
  };

  AreaTouches(const world::Field& field, double sure) : field_(field), sure_(sure) {}

  /// @return valid until the next call
  const std::vector<One>& update(const world::TrackedFrame& frame, const world::GameState& state);
  void reset() {
    past_.clear();
    carried_ = 0;
  }

 private:
  std::optional<world::Touch> carried(const world::TrackedFrame& frame);

  world::Field field_;
  double sure_;
  RobotPast past_;
  world::RobotId carrier_;
  int carried_ = 0;  // frames in a row
  std::vector<One> found_;
};

}  // namespace detectors
