#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "autoref/detectors/robot_past.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BOT_CRASH_UNIQUE, BOT_CRASH_DRAWN: two robots of different teams ran into each other.
///
/// Rule    laws of 2015, Law 12: substantial contact, a direct free kick; a penalty in the offender's own
///         area (the automaton's business). Decision 1: at similar speeds play goes on (drawn).
/// Guard   closing speed along the line between the centres when the hulls touch - crash_speed  [m/s], from
///         the last frame before the robots are within a tenth of contact, crash_braking taken off. Robots
///         that would pass each other are none, nor are those whose places of the last 0.07 s do not show at
///         least half that speed (a jump of the filter).
/// Blames  the robot whose own part of the closing speed is greater by crash_speed_difference; else both.
/// Spares  an advantage (Law 5, decision 2): the victim's team touched the ball last, at most 2 s ago, and a
///         team-mate of the victim is nearest to it. Then it is an event, but no foul.
/// Resets  a pair is reported once until it is 50 mm apart again, and at most every 2 s.
/// Source  numbers: reference "protocol", 6.3 and 6.4; the laws have had them since 2016.
class Collision final : public Detector {
 public:
  explicit Collision(const world::RuleSet& rules)
      : field_(rules.field),
        speed_(rules.crash_speed),
        difference_(rules.crash_speed_difference),
        braking_(rules.crash_braking),
        advantage_(rules.advantage) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    before_.clear();
    past_.clear();
    pairs_ = {};
  }

 private:
  struct Pair {
    bool close = false;
    std::optional<world::Time> reported;
  };
  using Pairs = std::array<std::array<Pair, world::max_robot_number + 1>, world::max_robot_number + 1>;
  struct Impact {
    double yellow = 0;  // [m/s] towards the other one
    double blue = 0;
  };

  std::optional<Impact> impact(world::RobotId yellow, world::RobotId blue) const;
  bool believable(world::RobotId yellow, world::RobotId blue, double speed) const;
  bool has_advantage(const world::TrackedFrame& frame, const world::GameState& state,
                     world::RobotId victim) const;

  world::Field field_;
  double speed_;
  double difference_;
  double braking_;
  bool advantage_;
  std::vector<world::TrackedRobot> before_;  // robots of the last frame
  world::Time before_time_;
  RobotPast past_;
  Pairs pairs_;  // yellow's number, blue's number
};

}  // namespace detectors
