#include "autoref/detectors/ball_touched.h"

namespace detectors {

std::vector<world::GameEvent> BallTouched::update(const world::TrackedFrame& frame,
                                                  const world::GameState& state) {
  std::vector<world::GameEvent> events;
  for (const world::Touch& touch : frame.touches) {
    if (touch.time < state.location_time) continue;  // I-33: the kick itself, or before it
    if (world::distance_outside_lines(field_, touch.position) > field_.ball_radius) continue;
    events.push_back({touch.time, world::BallTouched{touch}});
  }
  return events;
}

}  // namespace detectors
