#pragma once

#include "autoref/detectors/detector.h"
#include "autoref/detectors/goal.h"

namespace detectors {

/// CHIPPED_GOAL: a goal that does not count, because the ball was too high before.
///
/// Rule    laws of 2015, Law 12, indirect free kicks and decision 7: a robot made the ball's top rise above
///         150 mm, and it went into the opponents' goal without having touched a team-mate of that robot
///         while below 150 mm, and without having rolled ("stopped bouncing"). Into the robot's own goal it
///         counts, unless a touch of an opponent made it rise above 150 mm: then that opponent is the one.
/// Guard   that of the goal, in the same tick, which it spoils. A ball is high when TrackedBall::position or
///         Flight::highest says so; it rolls when it had no flight for chip_rolling.
/// Blames  who touched the ball last before it was high.
/// Limits  as good as the filter's heights; with RuleSet::chip_model off no ball is ever high.
class ChippedGoal final : public Detector {
 public:
  explicit ChippedGoal(const world::RuleSet& rules)
      : field_(rules.field), height_(rules.chip_height), rolling_(rules.chip_rolling), goal_(rules) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    chips_ = {};
    grounded_since_.reset();
    goal_.reset();
  }

 private:
  struct Chip {
    world::RobotId by;
    world::Vector2d kick;  // [m]
    double highest = 0;    // [m] top of the ball
  };

  void watch_height(const world::TrackedFrame& frame, const world::GameState& state);
  void watch_touches(const world::TrackedFrame& frame);

  world::Field field_;
  double height_;
  world::Duration rolling_;
  Goal goal_;
  world::PerTeam<std::optional<Chip>> chips_;  // by the team that made the ball fly
  std::optional<world::Time> grounded_since_;  // first frame in a row without flight
};

}  // namespace detectors
