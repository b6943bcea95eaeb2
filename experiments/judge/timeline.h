#pragma once

#include <deque>

#include "sim/world/game_state.h"
#include "sim/world/time.h"

namespace judge {

/// What the acting referee had signalled when, for whoever looks at the same game a little earlier or later.
class Timeline {
 public:
  /// @param frame  time of the frame that it judged in this state
  void add(world::Time frame, const world::GameState& before) {
    samples_.push_back({frame, before});
    if (samples_.size() > 180) samples_.pop_front();  // three seconds
  }
  bool empty() const { return samples_.empty(); }

  /// The state in which it judged, or would have judged, a frame of that time.
  /// @pre not empty
  const world::GameState& at(world::Time frame) const {
    const Sample* found = &samples_.back();
    for (auto it = samples_.rbegin(); it != samples_.rend() && it->frame >= frame; ++it) found = &*it;
    return found->state;
  }

 private:
  struct Sample {
    world::Time frame;
    world::GameState state;
  };
  std::deque<Sample> samples_;
};

}  // namespace judge
