#include "autoref/detectors/aimless_kick.h"

#include <cmath>

#include "autoref/detectors/ball.h"

namespace detectors {

Events AimlessKick::update(const world::TrackedFrame& frame, const world::GameState& state) {
  Events icing;
  for (const world::GameEvent& event : exit_.update(frame, state)) {
    const auto* left = std::get_if<world::BallLeftFieldGoalLine>(&event.what);
    if (!left || std::abs(left->location.y()) < field_.goal_width / 2) continue;
    const auto touch = last_touch(frame, state, event.time);
    if (!touch || touch->probability < sure_) continue;
    const double own = world::sign(world::defended_side(state, touch->robot.team));
    const bool from_own_half = touch->position.x() * own >= margin_;
    if (!from_own_half || left->location.x() * own > 0) continue;
    icing.push_back({event.time, world::AimlessKick{touch->robot, left->location, touch->position}});
  }
  return icing;
}

}  // namespace detectors
