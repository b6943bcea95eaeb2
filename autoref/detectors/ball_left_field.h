#pragma once

#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BALL_LEFT_FIELD_TOUCH_LINE, BALL_LEFT_FIELD_GOAL_LINE: the whole ball crossed a line, without a goal.
///
/// Rule    laws of 2015, Law 9; paper, Algorithm 2: certain with the third observed frame outside in a row.
/// Guard   distance outside the lines - ball radius  [m]
/// Where   the point where the way from the last place inside to the present place crosses the boundary.
/// Hidden  a robot that hides the ball carries it out: it is certain after exit_frames_hidden frames in which
///         the ball is surely outside, at a robot.
/// Waits   for at most 250 ms while nobody can say whether a ball that has just been kicked flies, since a
///         camera shows a ball in the air too far out; does not wait for a ball that had rolled out before.
/// When    interpolated; if nobody saw the ball cross the line, its way since it is outside is followed back.
/// Resets  when the ball is inside; an exit is reported again only after exit_frames in a row 20 mm inside.
///         A ball between the posts belongs to the goal detector: here it counts neither as inside nor as
///         outside until it is behind the goal (a chip over the bar).
/// Source  Algorithm 2 with I-6 and I-25. Ours: exit_frames_jump after a jump that no ball can make, since it
///         is more likely a false ball; exit_frames_mouth for a way through the goal's mouth, since the
///         filter runs through the goal's back before it believes the bounce.
class BallLeftField final : public Detector {
 public:
  explicit BallLeftField(const world::RuleSet& rules)
      : field_(rules.field),
        frames_(rules.exit_frames),
        frames_mouth_(rules.exit_frames_mouth),
        frames_jump_(rules.exit_frames_jump),
        frames_hidden_(rules.exit_frames_hidden) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    last_inside_.reset();
    seen_inside_.reset();
    believed_.reset();
    first_outside_.reset();
    count_ = 0;
    hidden_ = 0;
    inside_ = 0;
    reported_ = false;
  }

 private:
  struct Sample {
    world::Time time;
    world::Vector2d ball;
  };

  Events judge(const world::TrackedFrame& frame, const world::Vector2d& ball, const world::GameState& state);
  bool is_carried_out(const world::TrackedFrame& frame);
  world::Time instant(const Sample& now) const;
  double guard(const world::Vector2d& ball) const;
  bool is_certain(bool in_mouth) const;

  world::Field field_;
  int frames_;
  int frames_mouth_;
  int frames_jump_;
  int frames_hidden_;
  std::optional<Sample> last_inside_;  // seen, or hidden by a robot
  std::optional<Sample> seen_inside_;
  std::optional<world::Vector2d> believed_;  // [m] where it was in the last frame, if hidden then
  std::optional<Sample> first_outside_;
  bool rolled_out_ = false;  // on the ground, not slowly, before any kick that may have made it fly
  int count_ = 0;            // observed frames outside in a row
  int hidden_ = 0;           // frames among them in which a robot hid it outside
  int inside_ = 0;           // observed frames in a row clearly inside
  bool reported_ = false;    // this exit has been reported
};

}  // namespace detectors
