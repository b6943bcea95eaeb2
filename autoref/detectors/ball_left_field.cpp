#include "autoref/detectors/ball_left_field.h"

#include "autoref/detectors/ball.h"
#include "sim/world/crossing.h"

namespace detectors {
namespace {

constexpr double goal_back_margin = 0.05;  // [m] overshoot of the filter at the goal's back, ours

}  // namespace

Events BallLeftField::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto ball = observed_ball(frame);
  if (!ball) return {};

  const auto guard = [this](const world::Vector2d& place) {
    return world::distance_outside_lines(field_, place) - field_.ball_radius;
  };
  if (guard(*ball) <= 0) {
    last_inside_ = Sample{frame.time, *ball};
    first_outside_.reset();
    count_ = 0;
    reported_ = false;
    return {};
  }
  if (in_goal(field_, *ball, goal_back_margin)) return {};

  if (!first_outside_) first_outside_ = Sample{frame.time, *ball};
  ++count_;
  const Crossing where = crossing(field_, last_inside_ ? last_inside_->ball : *ball, *ball);
  if (reported_ || count_ < frames_needed(where.in_mouth)) return {};
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

int BallLeftField::frames_needed(bool in_mouth) const {
  const bool jumped = last_inside_ && !plausible_step(last_inside_->ball, first_outside_->ball,
                                                      first_outside_->time - last_inside_->time);
  if (jumped) return frames_jump_;
  return in_mouth ? frames_mouth_ : frames_;
}

}  // namespace detectors
