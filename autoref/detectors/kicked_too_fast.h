#pragma once

#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BOT_KICKED_BALL_TOO_FAST: the ball became faster than the laws allow.
///
/// Rule    laws of 2015, Law 12: at most 8 m/s.
/// Guard   speed - 1.02 max_ball_speed  [m/s]; certain with the fourth observed frame above it in a row
///         (I-30; the authors' code waits as long), when the ball has also gone half the way that the limit
///         would have taken it (ours: a hopping ball jumps to and fro between cameras). Speeds above 12 m/s
///         are no ball's.
/// Blames  the last toucher, when it touched the ball at most 0.3 s before; otherwise the robot that was
/// nearest
///         when the ball sped up (ours).
/// Resets  when the ball is slower again.
class KickedTooFast final : public Detector {
 public:
  explicit KickedTooFast(const world::RuleSet& rules) : max_speed_(rules.max_ball_speed) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    before_.reset();
    began_.reset();
    count_ = 0;
    fastest_ = 0;
    reported_ = false;
  }

 private:
  struct Sample {
    world::Time time;
    world::Vector2d ball;
    std::optional<world::RobotId> nearest;
  };

  double max_speed_;
  std::optional<Sample> before_;  // last observed frame at a legal speed
  std::optional<Sample> began_;   // where the ball was when it sped up
  int count_ = 0;                 // observed frames too fast in a row
  double fastest_ = 0;            // [m/s] in them
  bool reported_ = false;
};

}  // namespace detectors
