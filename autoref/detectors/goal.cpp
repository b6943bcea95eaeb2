#include "autoref/detectors/goal.h"

#include <chrono>
#include <cmath>

#include "autoref/detectors/ball.h"
#include "sim/world/crossing.h"

namespace detectors {
namespace {

constexpr int frames_to_stay = 9;
constexpr int frames_before_return = 2;
constexpr int frames_behind = 3;
constexpr double at_post = 0.06;  // [m] a ball that hits a post seems to pass beside it for a frame
constexpr world::Duration post_frames = std::chrono::milliseconds{60};
constexpr double back_margin = 0.05;  // [m] overshoot of the filter at the goal's back
constexpr world::Duration unseen_limit = std::chrono::milliseconds{500};
constexpr world::Duration same_goal = std::chrono::milliseconds{500};

}  // namespace

double Goal::guard(const world::Vector2d& ball) const {
  return std::abs(ball.x()) - field_.half_length() - field_.ball_radius;
}

Events Goal::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto ball = observed_ball(frame);
  bool certain = false;
  if (!ball) {
    certain = entry_ && !entry_->decided && frame.time - entry_->time > unseen_limit;
  } else if (!entry_) {
    watch_for_entry(frame, *ball);
  } else {
    Entry& entry = *entry_;
    ++entry.frames;
    if (guard(*ball) <= 0) {
      certain = !entry.decided && entry.inside >= frames_before_return;
      if (!certain) entry_.reset();
      last_in_front_ = Sample{frame.time, *ball};
    } else if (in_goal(field_, *ball, back_margin)) {
      ++entry.inside;
      entry.behind = 0;
      certain = !entry.decided && entry.frames >= frames_to_stay;
    } else {
      if (++entry.behind >= frames_behind) entry.decided = true;
    }
  }
  if (!certain) return {};

  entry_->decided = true;
  told_ = frame.time;
  const world::Side side = entry_->place.x() > 0 ? world::Side::Positive : world::Side::Negative;
  const world::PossibleGoal goal{world::defending_team(state, side), state.last_touch, entry_->place};
  return {{entry_->time, goal}};
}

void Goal::watch_for_entry(const world::TrackedFrame& frame, const world::Vector2d& ball) {
  if (guard(ball) <= 0) {
    last_in_front_ = Sample{frame.time, ball};
    return;
  }
  if (!last_in_front_) return;
  const Sample before = *last_in_front_;
  last_in_front_.reset();  // one crossing, one decision

  const Crossing where = crossing(field_, before.ball, ball);
  const double beside = std::abs(where.point.y()) - field_.goal_width / 2;
  const bool met_post = !where.in_mouth && where.goal_line && beside < at_post;
  const bool came_in = where.in_mouth || (met_post && in_goal(field_, ball, back_margin));
  if (met_post && !came_in && frame.time - before.time < post_frames) {
    last_in_front_ = before;
    return;
  }
  if (!plausible_step(before.ball, ball, frame.time - before.time)) return;
  if (frame.ball->position.z() > field_.goal_height) return;
  if (!came_in) return;
  const auto when = world::rising_zero({before.time, guard(before.ball)}, {frame.time, guard(ball)});
  Entry entry;
  entry.time = when.value_or(frame.time);
  entry.place = where.point;
  entry.frames = 1;
  entry.inside = in_goal(field_, ball, back_margin) ? 1 : 0;
  entry.decided = told_ && frame.time - *told_ < same_goal;
  entry_ = entry;
}

}  // namespace detectors
