#pragma once

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// A robot touched the ball in play (the paper's "a robot touches the ball").
///
/// Finding touches is `autoref/touch`'s work; this detector says which of them concern the game: those after
/// play began and before the whole ball was out. A touch is reported a few frames late, with its own time.
class BallTouched final : public Detector {
 public:
  explicit BallTouched(const world::RuleSet& rules) : field_(rules.field) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {}

 private:
  world::Field field_;
};

}  // namespace detectors
