#pragma once

#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// ATTACKER_DOUBLE_TOUCHED_BALL: the robot that took the kick touched the ball again before anyone else did.
///
/// Rule    laws of 2015, Law 9, decision 1: the kicker may bump the ball, but not touch it after it has
///         travelled 50 mm; not after a forced start.
/// Certain in one of three cases; the kick's own late or repeated touch reports (I-33) satisfy none of them:
///         (a) The ball was clear of the kicker for 3 observed frames (30 mm between hull and ball, farther
///             than kick_travel from where it lay), and a touch by the kicker is dated after that.
///         (b) The ball was clear as in (a), and then the kicker has carried it for four frames, seen or
///             hidden.
///         (c) The ball never was clear, and for the sixth observed frame in a row it is at the kicker's
///             dribbler, kick_travel and 30 mm away from where it lay.
/// Source  distances and frames are ours: in the recorded game of 2022 a kick that accelerated over 0.2 m
///         was in reach for three frames and reported as a touch again just after.
class DoubleTouch final : public Detector {
 public:
  explicit DoubleTouch(const world::RuleSet& rules) : field_(rules.field), travel_(rules.kick_travel) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    released_.reset();
    clear_ = carried_ = pushed_ = 0;
    reported_ = false;
  }

 private:
  world::Field field_;
  double travel_;
  std::optional<world::Time> released_;  // when the ball was clear of the kicker
  int clear_ = 0;                        // observed frames clear of the kicker in a row
  int carried_ = 0;                      // frames in a row in which the kicker carried it after that
  world::Time carried_since_;
  int pushed_ = 0;  // observed frames in the kicker's reach too far from where it lay
  bool reported_ = false;
};

}  // namespace detectors
