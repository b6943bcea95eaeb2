#pragma once

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// KEEPER_HELD_BALL: a goalie kept the ball in its area too long.
///
/// Rule    laws of 2015, Law 12: more than 15 s of holding before it is released.
/// Guard   time with the ball at the goalie - keeper_hold  [s]. At the goalie: within 15 mm of its hull
///         (30 mm when nobody sees it) and in its defense area.
/// Resets  when the ball has been away for half a second. While it is held, NO_PROGRESS_IN_GAME waits.
/// Source  15 mm, 30 mm and the half second are ours: noise, and the observable separation of decision 5.
class KeeperHeldBall final : public Detector {
 public:
  explicit KeeperHeldBall(const world::RuleSet& rules) : field_(rules.field), limit_(rules.keeper_hold) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    since_.reset();
    reported_ = false;
  }

 private:
  world::Field field_;
  world::Duration limit_;
  std::optional<world::RobotId> holder_;
  std::optional<world::Time> since_;  // nothing: nobody holds it
  world::Time last_;                  // when the ball was last at the holder
  bool reported_ = false;
};

}  // namespace detectors
