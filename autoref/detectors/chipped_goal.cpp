#include "autoref/detectors/chipped_goal.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

// A touch so soon after the ball left the ground is the kick itself (ours:
// touches are dated to a few frames).
constexpr world::Duration of_the_kick = std::chrono::milliseconds{100};

// A flat kick of 6 m/s is taken for a chip for a frame or two, with 0.5 to 0.92; a chip passes this within
// eight sightings (ours, from 400 goals).
constexpr double certainty = 0.95;
constexpr world::Duration instant_error = std::chrono::milliseconds{50};  // of a kick, ours
constexpr double landed = 0.03;  // [m] height in the last frame of a flight, at most
// The filter ends a flight with its last hop of 10 mm; three frames on the ground are rolling (ours).
constexpr world::Duration landed_rolling = std::chrono::milliseconds{45};
constexpr double fastest_fall = 6;     // [m/s] from 1.8 m: no ball falls faster, but a filter may think again
constexpr double robot_height = 0.15;  // [m] laws of 2015
constexpr double height_error = 0.03;  // [m] of the filter (README of the tracker)

bool is_same(const std::optional<world::Time>& a, world::Time b) {
  return a && std::chrono::abs(*a - b) < instant_error;
}

}  // namespace

Events ChippedGoal::update(const world::TrackedFrame& frame, const world::GameState& state) {
  // What the ball does behind the line is no matter any more, but it may show whether it flew before.
  const bool in_front = frame.ball && std::abs(frame.ball->position.x()) <= field_.half_length();
  if (in_front) {
    watch_touches(frame, state);
    watch_height(frame);
  }
  if (frame.ball) watch_certainty(*frame.ball);
  Events chipped;
  for (const world::GameEvent& event : goal_.update(frame, state)) {
    const auto& goal = std::get<world::PossibleGoal>(event.what);
    const std::optional<Chip>& chip = chips_[world::opponent(goal.defending)];
    if (!chip || !chip->sure) continue;
    chipped.push_back({event.time, world::ChippedGoal{chip->by, goal.location, chip->kick, chip->highest}});
  }
  return chipped;
}

void ChippedGoal::watch_certainty(const world::TrackedBall& ball) {
  for (const world::Team team : world::both_teams) {
    std::optional<Chip>& chip = chips_[team];
    if (!chip || chip->sure) continue;
    if (!ball.flight) {
      chip.reset();  // the filter has taken it back
    } else if (ball.airborne >= certainty) {
      chip->sure = true;
    }
  }
}

// The last one that can have touched the ball: above a robot it passes.
const world::Touch* ChippedGoal::toucher(const world::Flight& flight) const {
  for (auto touch = touches_.rbegin(); touch != touches_.rend(); ++touch) {
    const double since = world::seconds(touch->time - flight.kicked);
    const double height = (flight.launch_velocity.z() - 9.81 / 2 * since) * since;
    if (since < 0 || height < robot_height + height_error) return &*touch;
  }
  return nullptr;
}

void ChippedGoal::watch_height(const world::TrackedFrame& frame) {
  const world::TrackedBall& ball = *frame.ball;
  const double height = ball.flight ? ball.position.z() : 0;
  const double fall = before_ ? fastest_fall * world::seconds(frame.time - before_->first) + height_error : 0;
  if (before_ && height < before_->second - fall) chips_ = {};
  before_.emplace(frame.time, height);
  if (!ball.flight) {
    if (!grounded_since_) grounded_since_ = frame.time;
    const world::Duration needed = last_height_ < landed ? std::min(rolling_, landed_rolling) : rolling_;
    if (frame.time - *grounded_since_ >= needed) chips_ = {};
    return;
  }
  grounded_since_.reset();
  last_height_ = ball.position.z();
  const world::Touch* const touch = toucher(*ball.flight);
  if (!touch) return;
  // The height of the whole flight is the last toucher's, unless the touch came during it.
  const bool began_it = touch->time <= ball.flight->kicked + of_the_kick;
  double highest = ball.position.z();
  if (began_it) highest = std::max(highest, ball.flight->highest);
  const double top = highest + 2 * field_.ball_radius;
  std::optional<Chip>& chip = chips_[touch->robot.team];
  if (began_it && chip && chip->by == touch->robot && is_same(chip->kicked, ball.flight->kicked)) {
    chip->highest = top;  // the filter knows it better now
    if (top <= height_) chip.reset();
    return;
  }
  if (top <= height_) return;
  if (!chip || chip->by != touch->robot) {
    chip = Chip{touch->robot, began_it ? ball.flight->from : touch->position, top, {}};
  }
  if (began_it) chip->kicked = ball.flight->kicked;
  chip->highest = std::max(chip->highest, top);
}

void ChippedGoal::watch_touches(const world::TrackedFrame& frame, const world::GameState& state) {
  const bool low = frame.ball->position.z() + 2 * field_.ball_radius <= height_;
  if (low) {
    for (const world::Touch& touch : frame.touches) {
      std::optional<Chip>& chip = chips_[touch.robot.team];
      if (chip && chip->by != touch.robot) chip.reset();
    }
  }
  const auto last = last_touch(frame, state, frame.time);
  if (!last) return;
  const auto same = std::ranges::find(touches_, last->robot, &world::Touch::robot);
  if (same != touches_.end()) touches_.erase(same);
  if (touches_.size() == touches_.capacity()) touches_.erase(touches_.begin());
  touches_.push_back(*last);
}

}  // namespace detectors
