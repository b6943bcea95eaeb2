#include "autoref/detectors/ball_left_field.h"

#include <algorithm>

#include "autoref/detectors/ball.h"
#include "sim/world/crossing.h"

namespace detectors {
namespace {

constexpr double surely = 0.97;       // of a hidden ball to be outside; ours
constexpr double wrong_belief = 0.1;  // [m] a hidden ball that comes into view so far off was not there; ours
constexpr double hidden_gap = 0.05;   // [m] the robot that hides it is as near (README of the tracker)
constexpr world::Duration seen_crossing = std::chrono::milliseconds{100};  // from inside to outside; ours
// [m] on the line noise and cameras' offsets show a ball in and out; ours
constexpr double clearly_inside = 0.02;
constexpr double rolling_out = 1;  // [m/s] outwards: no noise shows this, ours
constexpr world::Duration longest_doubt = std::chrono::milliseconds{250};  // ours
constexpr double goal_back_margin = 0.05;  // [m] overshoot of the filter at the goal's back, ours

}  // namespace

Events BallLeftField::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (!frame.ball) return {};
  const world::Vector2d ball = on_ground(*frame.ball);
  Events events;
  if (frame.ball->observed || is_carried_out(frame)) events = judge(frame, ball, state);
  believed_.reset();
  if (!frame.ball->observed) believed_ = ball;
  return events;
}

// The ball is hidden by a robot, and well outside, not behind the goal's mouth.
bool BallLeftField::is_carried_out(const world::TrackedFrame& frame) {
  if (frames_hidden_ == 0 || !last_inside_) return false;
  const world::Vector2d ball = on_ground(*frame.ball);
  const world::TrackedRobot* robot = nearest_robot(frame, ball);
  if (!robot || gap_to_ball(field_, *robot, ball) > hidden_gap) return false;
  if (guard(ball) <= 0 && !first_outside_) last_inside_ = Sample{frame.time, ball};
  return guard(ball) > 0 && frame.ball->outside > surely;
}

double BallLeftField::guard(const world::Vector2d& ball) const {
  return world::distance_outside_lines(field_, ball) - field_.ball_radius;
}

Events BallLeftField::judge(const world::TrackedFrame& frame, const world::Vector2d& ball,
                            const world::GameState& state) {
  if (guard(ball) <= 0) {
    last_inside_ = seen_inside_ = Sample{frame.time, ball};
    first_outside_.reset();
    count_ = 0;
    hidden_ = 0;
    inside_ = guard(ball) < -clearly_inside ? inside_ + 1 : 0;
    if (inside_ >= frames_) reported_ = false;
    return {};
  }
  inside_ = 0;
  if (in_goal(field_, ball, goal_back_margin)) return {};

  if (!first_outside_) {
    first_outside_ = Sample{frame.time, ball};
    if (frame.ball->observed && believed_ && (*believed_ - ball).norm() > wrong_belief)
      last_inside_ = seen_inside_;
    rolled_out_ = !frame.ball->may_fly && last_inside_ &&
                  guard(ball) - guard(last_inside_->ball) >
                      rolling_out * world::seconds(frame.time - last_inside_->time);
  }
  ++(frame.ball->observed ? count_ : hidden_);
  const Crossing where = crossing(field_, last_inside_ ? last_inside_->ball : ball, ball);
  if (reported_ || !is_certain(where.in_mouth)) return {};
  // A ball that has just been kicked may fly, and is then not where a camera shows it.
  if (!rolled_out_ && frame.ball->may_fly && frame.time - first_outside_->time < longest_doubt) return {};
  reported_ = true;

  const world::Time when = instant({frame.time, ball});
  if (where.goal_line) return {{when, world::BallLeftFieldGoalLine{state.last_touch, where.point}}};
  return {{when, world::BallLeftFieldTouchLine{state.last_touch, where.point}}};
}

// Where nobody saw it cross the line, it may have lain before it: then its way since it is outside is
// followed back.
world::Time BallLeftField::instant(const Sample& now) const {
  if (!last_inside_) return first_outside_->time;
  const Sample& first = *first_outside_;
  const double way = guard(now.ball) - guard(first.ball);
  if (first.time - last_inside_->time > seen_crossing && way > 0) {
    const auto ago = world::from_seconds(guard(first.ball) / way * world::seconds(now.time - first.time));
    return std::max(last_inside_->time, first.time - ago);
  }
  return world::rising_zero({last_inside_->time, guard(last_inside_->ball)}, {first.time, guard(first.ball)})
      .value_or(first.time);
}

bool BallLeftField::is_certain(bool in_mouth) const {
  const bool jumped = last_inside_ && !plausible_step(last_inside_->ball, first_outside_->ball,
                                                      first_outside_->time - last_inside_->time);
  if (jumped) return count_ >= frames_jump_;
  if (in_mouth) return count_ >= frames_mouth_;
  if (frames_hidden_ == 0) return count_ >= frames_;
  return count_ * frames_hidden_ + hidden_ * frames_ >= frames_ * frames_hidden_;
}

}  // namespace detectors
