#pragma once

#include <array>
#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// NO_PROGRESS_IN_GAME: the ball is stuck.
///
/// Rule    Law 5 of 2015 leaves it to the referee; the limits are those of the authors' code:
///         less than 0.25 m in each second, for 12 s.
/// Guard   time since progress - stuck_time  [s]. Progress is 0.25 m away from where the ball was at most one
///         second before. A ball that nobody sees makes none, unless a robot has it at its dribbler; a ball
///         that a goalie holds in its area is KEEPER_HELD_BALL's, where that rule runs.
class NoProgress final : public Detector {
 public:
  explicit NoProgress(const world::RuleSet& rules)
      : field_(rules.field),
        distance_(rules.stuck_distance),
        limit_(rules.stuck_time),
        goalie_may_hold_(world::runs(rules, "goalie holds the ball")) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    progress_.reset();
    count_ = 0;
  }

 private:
  world::Field field_;
  double distance_;
  world::Duration limit_;
  bool goalie_may_hold_;
  struct Sample {
    world::Time time;
    world::Vector2d place;  // [m]
  };
  std::optional<world::Time> progress_;  // when there was some last
  std::array<Sample, 72> samples_;       // a ring: the observed ball in the last second, 15 ms apart or more
  std::size_t next_ = 0;
  std::size_t count_ = 0;
};

}  // namespace detectors
