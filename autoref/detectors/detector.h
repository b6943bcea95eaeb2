#pragma once

#include <boost/container/small_vector.hpp>

#include "sim/world/game_event.h"
#include "sim/world/game_state.h"
#include "sim/world/tracked_frame.h"

namespace detectors {

/// What a detector saw in one tick. Two fit without allocating: a touch of the ball, reported in every frame
/// of contact, must not cost memory.
using Events = boost::container::small_vector<world::GameEvent, 2>;

/// Watches a stream of frames for one event of the rulebook. Nothing else: no I/O, no clock, no randomness.
class Detector {
 public:
  virtual ~Detector() = default;

  /// Looks at the next frame and returns the events that became certain with it.
  ///
  /// Called exactly once per tick, so that only time advances a detector's memory; `state` is as the tick
  /// began. Frame times strictly increase between two calls of `reset`.
  virtual Events update(const world::TrackedFrame& frame, const world::GameState& state) = 0;

  /// Forgets the past. Called when the automaton enters a location that uses this detector.
  virtual void reset() = 0;
};

}  // namespace detectors
