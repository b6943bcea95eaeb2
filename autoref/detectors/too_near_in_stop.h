#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// A robot stayed too near the ball while play was stopped.
///
/// Rule    laws of 2015, Laws 5 and 9: at least 0.5 m from the ball while the command is STOP (or GOAL). The
///         laws name no punishment before the restart: it is noted.
/// Guard   stop_distance - distance_margin - (hull to ball)  [m] for stop_grace, the ball at rest meanwhile
///         (within 50 mm; a measure of speed would be at the mercy of noise).
/// Resets  a robot is reported once per stoppage.
class TooNearInStop final : public Detector {
 public:
  explicit TooNearInStop(const world::RuleSet& rules)
      : field_(rules.field),
        distance_(rules.stop_distance - rules.distance_margin),
        grace_(rules.stop_grace) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    watched_ = {};
    lies_at_.reset();
  }

 private:
  struct Watched {
    std::optional<world::Time> since;  // too near, without a break
    bool reported = false;
  };

  world::Field field_;
  double distance_;
  world::Duration grace_;
  std::optional<world::Vector2d> lies_at_;  // [m] the ball
  world::PerTeam<std::array<Watched, world::max_robot_number + 1>> watched_;
};

}  // namespace detectors
