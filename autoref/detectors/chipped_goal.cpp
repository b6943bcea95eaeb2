#include "autoref/detectors/chipped_goal.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

// A touch so soon after the ball left the ground is the kick itself (ours: touches are dated to a few
// frames).
constexpr world::Duration of_the_kick = std::chrono::milliseconds{100};

}  // namespace

Events ChippedGoal::update(const world::TrackedFrame& frame, const world::GameState& state) {
  // What the ball does behind the line is no matter any more.
  const bool in_front = frame.ball && std::abs(frame.ball->position.x()) <= field_.half_length();
  if (in_front) {
    watch_touches(frame);
    watch_height(frame, state);
  }
  Events chipped;
  for (const world::GameEvent& event : goal_.update(frame, state)) {
    const auto& goal = std::get<world::PossibleGoal>(event.what);
    const std::optional<Chip>& chip = chips_[world::opponent(goal.defending)];
    if (!chip) continue;
    chipped.push_back({event.time, world::ChippedGoal{chip->by, goal.location, chip->kick, chip->highest}});
  }
  return chipped;
}

void ChippedGoal::watch_height(const world::TrackedFrame& frame, const world::GameState& state) {
  const world::TrackedBall& ball = *frame.ball;
  if (!ball.flight) {
    if (!grounded_since_) grounded_since_ = frame.time;
    if (frame.time - *grounded_since_ >= rolling_) chips_ = {};
    return;
  }
  grounded_since_.reset();
  const auto touch = last_touch(frame, state, frame.time);
  if (!touch) return;
  // The height of the whole flight is the last toucher's, unless the touch came during it.
  const bool began_it = touch->time <= ball.flight->kicked + of_the_kick;
  double highest = ball.position.z();
  if (began_it) highest = std::max(highest, ball.flight->highest);
  const double top = highest + 2 * field_.ball_radius;
  if (top <= height_) return;
  std::optional<Chip>& chip = chips_[touch->robot.team];
  if (!chip || chip->by != touch->robot) {
    chip = Chip{touch->robot, began_it ? ball.flight->from : touch->position, top};
  }
  chip->highest = std::max(chip->highest, top);
}

void ChippedGoal::watch_touches(const world::TrackedFrame& frame) {
  const bool low = frame.ball->position.z() + 2 * field_.ball_radius <= height_;
  if (!low) return;
  for (const world::Touch& touch : frame.touches) {
    std::optional<Chip>& chip = chips_[touch.robot.team];
    if (chip && chip->by != touch.robot) chip.reset();
  }
}

}  // namespace detectors
