#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "autoref/touch/last_toucher.h"
#include "sim/world/field.h"
#include "sim/world/rules/rule_set.h"
#include "sim/world/tracked_frame.h"

namespace touch {

using world::Vector2d;

/// Who touches the ball: the paper's `accel`, `line` and `backtrack`, our `reach` and our
/// `likelihood`, joined by OR.
///
/// The first four report at most one touch per robot and frame; contact that lasts is reported
/// again and again, since what counts is who touched last. A contributor needs as many consecutive
/// frames as it looks back (accel 3, backtrack 4, line 6, reach 3), of the ball and of that robot;
/// a gap in time starts its memory anew.
///
/// `likelihood` also reports a touch again, with its old time, when its probability has changed, and an older
/// touch again when a newer one turns out to be none. So whoever reads touches in order always has the most
/// likely last toucher.
class TouchDetector {
 public:
  TouchDetector(const world::Geometry& geometry, world::TouchAlgorithms algorithms);

  /// Takes in the next frame and replaces `out` by the touches found in it: of `likelihood`, then of the
  /// others sorted by robot.
  /// @param images  of this tick; only `likelihood` looks at them. None: it makes do with the frame
  /// @pre frame.time is later than the last one's, except after reset()
  void update(const world::TrackedFrame& frame, std::span<const world::Detection> images,
              std::vector<world::Touch>& out);
  void update(const world::TrackedFrame& frame, std::vector<world::Touch>& out) { update(frame, {}, out); }

  void reset();

 private:
  static constexpr int memory = 8;  // frames: `backtrack` of the authors' code

  struct Sample {
    world::Time time;
    Vector2d ball = Vector2d::Zero();           // [m]
    Vector2d ball_velocity = Vector2d::Zero();  // [m/s]
  };
  struct RobotHistory {
    int length = 0;                                // consecutive frames known
    std::array<Vector2d, memory> ball_from_robot;  // [m] the paper's d_0 .. d_5, newest first
    std::optional<world::Time> line_time;          // when `line` saw a touch last
    int carried = 0;                               // frames in a row in which it moved the ball along
    world::Time time;                              // of the newest
  };

  void forget_frames();
  bool remember(const world::TrackedFrame& frame);
  void remember(const world::TrackedRobot& robot, RobotHistory& history) const;
  bool carries(const world::TrackedRobot& robot) const;
  /// How many frames ago the robot touched the ball, as far as any algorithm can tell.
  std::optional<int> frames_since_touch(RobotHistory& history, bool is_closest) const;
  void ask_frames(const world::TrackedFrame& frame);

  world::Field field_;
  world::TouchAlgorithms algorithms_;
  world::TouchAlgorithms asked_;  // of the four that look at frames; for `likelihood` alone the paper's three
  LastToucher last_toucher_;
  int length_ = 0;                      // frames of ball history
  std::array<Sample, memory> samples_;  // newest first
  std::array<RobotHistory, robot_slots> histories_;
  std::vector<world::Touch> found_;         // by those, in this frame
  std::optional<world::Touch> last_found_;  // the last one in the field
};

}  // namespace touch
