#include "autoref/detectors/defender_in_area.h"

#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr world::Duration cool_down = std::chrono::seconds{2};

}  // namespace

Events DefenderInArea::update(const world::TrackedFrame& frame, const world::GameState& state) {
  for (const auto& [touch, place] : touches_.update(frame, state)) {
    const world::RobotId robot = touch.robot;
    if (robot.number == state.keeper[robot.team]) continue;
    const double depth = depth_in_area(field_, world::defended_side(state, robot.team), place);
    if (depth < margin_) continue;
    const bool goes_on = last_ && frame.time - *last_ < cool_down;
    last_ = frame.time;
    if (goes_on) continue;
    const bool wholly = depth > 2 * field_.robot_radius + margin_;
    return {{touch.time, world::DefenderInDefenseArea{robot, place, depth, wholly}}};
  }
  return {};
}

}  // namespace detectors
