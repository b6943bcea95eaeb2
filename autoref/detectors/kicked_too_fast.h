#pragma once

#include <array>
#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BOT_KICKED_BALL_TOO_FAST: the ball became faster than the laws allow.
///
/// Rule    laws of 2015, Law 12: at most 8 m/s.
/// Guard   way - (max_ball_speed t - a t^2 / 2)  [m]: between two of the last seven observed frames the ball
///         went at least surplus_way farther than a ball kicked at the limit, which slides and slows down by
///         a. This must be so in at least three frames (I-30: not one); in each of them the ball moves as a
///         fast ball does, and the filter agrees. So a ball that is a little too fast takes longer to see
///         than one that is much too fast, and a ball that jumps between cameras is not reported.
/// Blames  the last toucher, when it touched the ball at most 0.1 s before it sped up; otherwise the robot
///         that was nearest when the ball sped up (ours); who took the kick when play began with it.
/// Resets  when the ball is slow again.
/// Source  ours. a = 3 m/s^2 (reference "football", 5); no step beyond 12 m/s is a ball's (TIGERs' cap).
class KickedTooFast final : public Detector {
 public:
  explicit KickedTooFast(const world::RuleSet& rules) : max_speed_(rules.max_ball_speed) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    count_ = 0;
    reported_ = false;
  }

 private:
  struct Sample {
    world::Time time;
    world::Vector2d ball;
    double height;  // [m]
  };

  void begin(const world::TrackedFrame& frame, const Sample& sample);
  bool too_fast(const Sample& now) const;

  double max_speed_;
  // The ball in the last observed frames, oldest first; all but the first came by fast steps.
  std::array<Sample, 7> samples_;
  std::size_t count_ = 0;
  world::Time began_;      // the last frame of a slow ball
  world::Vector2d place_;  // [m] ball then
  std::optional<world::RobotId> nearest_;
  bool after_restart_ = false;  // it was fast when play began
  double fastest_ = 0;          // [m/s] since then
  bool reported_ = false;
};

}  // namespace detectors
