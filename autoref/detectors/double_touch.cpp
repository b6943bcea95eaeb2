#include "autoref/detectors/double_touch.h"

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double clear_distance = 0.05;  // [m] hull to the ball's surface
constexpr double carry_margin = 0.03;    // [m]
constexpr int clear_frames = 5;
constexpr int carry_frames = 6;

}  // namespace

Events DoubleTouch::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (reported_ || !state.kicker || !state.kick_position) return {};

  if (released_) {
    for (const world::Touch& touch : frame.touches) {
      if (touch.robot != *state.kicker || touch.time <= *released_) continue;
      reported_ = true;
      return {{touch.time, world::AttackerDoubleTouchedBall{touch.robot, touch.position}}};
    }
  }
  const world::TrackedRobot* kicker = find_robot(frame, *state.kicker);
  const auto ball = observed_ball(frame);
  if (!kicker || !ball) return {};

  const double travelled = (*ball - *state.kick_position).norm();
  const double gap = hull_distance(field_, *kicker, *ball) - field_.ball_radius;
  clear_ = travelled > travel_ && gap > clear_distance ? clear_ + 1 : 0;
  if (!released_ && clear_ >= clear_frames) released_ = frame.time;

  carried_ = kicker->ball_in_reach && travelled > travel_ + carry_margin ? carried_ + 1 : 0;
  if (carried_ < carry_frames) return {};
  reported_ = true;
  return {{frame.time, world::AttackerDoubleTouchedBall{kicker->id, *ball}}};
}

}  // namespace detectors
