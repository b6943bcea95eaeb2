#include "autoref/detectors/double_touch.h"

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double clear_distance = 0.03;  // [m] hull to the ball's surface
constexpr double push_margin = 0.03;     // [m]
constexpr int clear_frames = 3;
constexpr int carry_frames = 4;
constexpr int push_frames = 6;

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
  if (!kicker || !frame.ball) return {};
  const world::Vector2d ball = on_ground(*frame.ball);

  if (released_) {
    carried_ = carries(field_, *kicker, *frame.ball) ? carried_ + 1 : 0;
    if (carried_ == 1) carried_since_ = frame.time;
    if (carried_ < carry_frames) return {};
    reported_ = true;
    return {{carried_since_, world::AttackerDoubleTouchedBall{kicker->id, ball}}};
  }
  if (!frame.ball->observed) return {};
  const double travelled = (ball - *state.kick_position).norm();
  const bool clear = travelled > travel_ && gap_to_ball(field_, *kicker, ball) > clear_distance;
  clear_ = clear ? clear_ + 1 : 0;
  if (clear_ >= clear_frames) released_ = frame.time;

  pushed_ = kicker->ball_in_reach && travelled > travel_ + push_margin ? pushed_ + 1 : 0;
  if (pushed_ < push_frames) return {};
  reported_ = true;
  return {{frame.time, world::AttackerDoubleTouchedBall{kicker->id, ball}}};
}

}  // namespace detectors
