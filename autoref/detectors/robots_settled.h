#pragma once

#include <array>
#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// Ball in place and robots steady: play can be restarted (the paper's "the robots are ready").
///
/// Rule    paper, Algorithm 3: nothing faster than V_b, V_r for one second; with the ball within
///         placement_tolerance of its place (I-16), counted from the entry into GAME_OFF (I-15).
///         Something moves when both the filter and the mean over the last quarter of a second say so: the
///         filter's word of one instant shakes by more than V_b and V_r when cameras are bad.
/// Guard   min(time since something moved or the ball was not in place - settled_for, ...)  [s],
///         or the whole wait - settle_limit (I-17, "or after some time has passed").
/// Kickoff the robots must also be in their own halves, and before the READY of a penalty where Law 14 wants
///         them; for that the referee waits twice the limit, because at half-time they drive over the whole
///         field (ours: 9 m at the 0.3 m/s of a slow team).
class RobotsSettled final : public Detector {
 public:
  explicit RobotsSettled(const world::RuleSet& rules)
      : field_(rules.field),
        penalty_line_(rules.penalty_line),
        ball_speed_(rules.ball_settled_speed),
        robot_speed_(rules.robot_settled_speed),
        tolerance_(rules.placement_tolerance),
        settled_for_(rules.settled_for),
        limit_(rules.settle_limit) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    entered_.reset();
    start_.reset();
    places_ = 0;
  }

 private:
  static constexpr std::size_t window = 15;  // frames, a quarter of a second
  static constexpr std::size_t robots = 2 * (world::max_robot_number + 1);
  /// Where everything was in one frame.
  struct Place {
    world::Time time;
    std::optional<world::Vector2d> ball;
    std::array<std::optional<world::Vector2d>, robots> robot;
  };

  void remember(const world::TrackedFrame& frame);
  bool steady(const world::TrackedFrame& frame, const world::GameState& state) const;

  bool in_position(const world::TrackedFrame& frame, const world::GameState& state) const;

  world::Field field_;
  double penalty_line_;
  double ball_speed_;
  double robot_speed_;
  double tolerance_;
  world::Duration settled_for_;
  world::Duration limit_;
  std::optional<world::Time> entered_;
  std::array<Place, window + 1> past_;  // a ring
  std::size_t places_ = 0;              // remembered so far
  std::optional<world::Time> start_;    // the paper's s_start: when it was last not so
};

}  // namespace detectors
