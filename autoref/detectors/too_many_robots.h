#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// TOO_MANY_ROBOTS: a team plays with more robots than it may.
///
/// Rule    laws of 2015, Laws 3 and 12: six, less one for each card. A surplus robot leaves at a stoppage, so
///         cards of this passage of play do not count yet; the laws know no punishment: it is noted.
/// Guard   robots known for surplus_robot_time and seen now - robots allowed, at least 1. A misread number
///         makes a robot for an image or two, never so long.
/// Resets  once per passage of play and team.
class TooManyRobots final : public Detector {
 public:
  explicit TooManyRobots(const world::RuleSet& rules)
      : most_(rules.robots_per_team), time_(rules.surplus_robot_time) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    allowed_.reset();
    reported_ = {};
    known_ = {};
  }

 private:
  struct Known {
    std::optional<world::Time> since;
    world::Time last;
  };

  int most_;
  world::Duration time_;
  std::optional<world::PerTeam<int>> allowed_;  // when this passage of play began
  world::PerTeam<bool> reported_{};
  world::PerTeam<std::array<Known, world::max_robot_number + 1>> known_;
};

}  // namespace detectors
