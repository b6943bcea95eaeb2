#include "autoref/detectors/ball_left_field.h"

#include "autoref/detectors/ball.h"
#include "sim/world/crossing.h"

namespace detectors {
namespace {

// A hidden ball is known to some 15 mm; the robot that hides it is within 50 mm (README of the tracker).
constexpr double surely_outside = 0.03;    // [m]
constexpr double hidden_gap = 0.05;        // [m]
constexpr double goal_back_margin = 0.05;  // [m] overshoot of the filter at the goal's back, ours

}  // namespace

Events BallLeftField::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto ball = observed_ball(frame);
  if (!ball && !is_carried_out(frame)) return {};
  return judge(frame, on_ground(*frame.ball), state);
}

// The ball is hidden by a robot, and well outside, not behind the goal's mouth.
bool BallLeftField::is_carried_out(const world::TrackedFrame& frame) {
  if (frames_hidden_ == 0 || !frame.ball || frame.ball->observed || !last_inside_) return false;
  const world::Vector2d ball = on_ground(*frame.ball);
  const world::TrackedRobot* robot = nearest_robot(frame, ball);
  if (!robot || gap_to_ball(field_, *robot, ball) > hidden_gap) return false;
  if (guard(ball) <= 0 && !first_outside_) last_inside_ = Sample{frame.time, ball};
  return guard(ball) > surely_outside;
}

double BallLeftField::guard(const world::Vector2d& ball) const {
  return world::distance_outside_lines(field_, ball) - field_.ball_radius;
}

Events BallLeftField::judge(const world::TrackedFrame& frame, const world::Vector2d& ball,
                            const world::GameState& state) {
  if (guard(ball) <= 0) {
    last_inside_ = Sample{frame.time, ball};
    first_outside_.reset();
    count_ = 0;
    hidden_ = 0;
    reported_ = false;
    return {};
  }
  if (in_goal(field_, ball, goal_back_margin)) return {};

  if (!first_outside_) first_outside_ = Sample{frame.time, ball};
  ++(frame.ball->observed ? count_ : hidden_);
  const Crossing where = crossing(field_, last_inside_ ? last_inside_->ball : ball, ball);
  if (reported_ || !is_certain(where.in_mouth)) return {};
  reported_ = true;

  world::Time when = first_outside_->time;
  if (last_inside_) {
    const auto crossed = world::rising_zero({last_inside_->time, guard(last_inside_->ball)},
                                            {first_outside_->time, guard(first_outside_->ball)});
    if (crossed) when = *crossed;
  }
  if (where.goal_line) return {{when, world::BallLeftFieldGoalLine{state.last_touch, where.point}}};
  return {{when, world::BallLeftFieldTouchLine{state.last_touch, where.point}}};
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
