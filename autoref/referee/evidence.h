#pragma once

#include <deque>
#include <span>
#include <string>

#include "autoref/automaton/occurrence.h"
#include "autoref/referee/call.h"
#include "sim/world/rules/rule_set.h"
#include "sim/world/tracked_frame.h"

namespace referee {

/// What the referee saw in the last seconds, to be told with a call.
class Evidence {
 public:
  static constexpr world::Duration span = std::chrono::seconds{3};

  void remember(const world::TrackedFrame& frame);

  /// The long record of a call, one line of JSON: the detector and its thresholds, the last touch with its
  /// probability and rival, what else was detected in the same tick (alternatives), every touch of the last
  /// 3 s, and ten times a second where the ball was and the robots that came within 1 m of it. Lengths in
  /// metres, times in seconds.
  std::string record(const Call& call, const world::RuleSet& rules, const world::GameState& state,
                     std::span<const automaton::Occurrence> occurrences) const;

 private:
  std::deque<world::TrackedFrame> frames_;
};

}  // namespace referee
