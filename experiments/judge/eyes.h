#pragma once

#include <span>

#include "autoref/touch/touch_detector.h"
#include "autoref/tracker/tracker.h"
#include "sim/world/rules/rule_set.h"

namespace judge {

/// How a referee of that rule set sees: filter and touch detection, joined as in the referee.
class Eyes {
 public:
  Eyes(const world::Geometry& geometry, const world::RuleSet& rules)
      : tracker_(geometry, {.ball_in_space = rules.chip_model}), touches_(geometry, rules.touch) {}

  /// @return whether there is a new frame
  bool see(std::span<const world::Detection> images) {
    const world::TrackedFrame* frame = tracker_.update(images);
    if (frame == nullptr) return false;
    if (frame->time <= frame_.time) touches_.reset();
    frame_ = *frame;
    frame_.touches.clear();
    touches_.update(frame_, images, frame_.touches);
    return true;
  }
  /// The last one, with its touches.
  const world::TrackedFrame& frame() const { return frame_; }

 private:
  tracker::Tracker tracker_;
  touch::TouchDetector touches_;
  world::TrackedFrame frame_;
};

}  // namespace judge
