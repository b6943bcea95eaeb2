#include "autoref/detectors/attacker_in_area.h"

#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr world::Duration cool_down = std::chrono::seconds{2};

}  // namespace

Events AttackerInArea::update(const world::TrackedFrame& frame, const world::GameState& state) {
  for (const auto& [touch, place] : touches_.update(frame, state)) {
    const world::RobotId robot = touch.robot;
    const world::Side attacked = world::other(world::defended_side(state, robot.team));
    const double depth = depth_in_area(field_, attacked, place);
    if (depth < margin_) continue;
    const bool goes_on = last_ && frame.time - *last_ < cool_down;
    last_ = frame.time;
    if (goes_on) continue;
    return {{touch.time, world::AttackerTouchedBallInDefenseArea{robot, place, touch.position, depth}}};
  }
  return {};
}

}  // namespace detectors
