#include "autoref/detectors/ball_touched.h"

#include "autoref/detectors/ball.h"

namespace detectors {

Events BallTouched::update(const world::TrackedFrame& frame, const world::GameState& state) {
  Events events;
  for (const world::Touch& touch : frame.touches) {
    if (!in_play(field_, state, touch)) continue;
    events.push_back({touch.time, world::BallTouched{touch}});
  }
  return events;
}

}  // namespace detectors
