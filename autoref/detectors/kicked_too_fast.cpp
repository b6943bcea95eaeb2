#include "autoref/detectors/kicked_too_fast.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double surplus_way = 0.018;       // [m] four times the noise of a way
constexpr double sliding = 3.0;             // [m/s^2]
constexpr double fast_step = 0.75;          // of the limit
constexpr double no_ball_is_faster = 12.0;  // [m/s]
constexpr double filter_agrees = 0.96;      // of the limit
constexpr std::size_t frames_needed = 3;
constexpr world::Duration recent_touch = std::chrono::milliseconds{100};

}  // namespace

void KickedTooFast::begin(const world::TrackedFrame& frame, const Sample& sample) {
  const world::TrackedRobot* nearest = nearest_robot(frame, sample.ball);
  nearest_ = nearest ? std::optional{nearest->id} : std::nullopt;
  began_ = sample.time;
  place_ = sample.ball;
  samples_[0] = sample;
  count_ = 1;
  fastest_ = 0;
  reported_ = false;
}

bool KickedTooFast::too_fast(const Sample& now) const {
  for (std::size_t n = 0; n + frames_needed < count_ + 1; ++n) {
    const double time = world::seconds(now.time - samples_[n].time);
    const double lawful = max_speed_ * time - sliding * time * time / 2;
    const double way = std::hypot((now.ball - samples_[n].ball).norm(), now.height - samples_[n].height);
    if (way - lawful >= surplus_way) return true;
  }
  return false;
}

Events KickedTooFast::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto ball = observed_ball(frame);
  if (!ball) return {};
  const Sample now{frame.time, *ball, frame.ball->position.z()};
  if (count_ == 0) {
    begin(frame, now);
    after_restart_ = true;
    return {};
  }
  const Sample& last = samples_[count_ - 1];
  const double step = (now.ball - last.ball).norm() / world::seconds(now.time - last.time);
  if (step < fast_step * max_speed_ || step > no_ball_is_faster) {
    begin(frame, now);
    after_restart_ = false;
    return {};
  }
  if (count_ == samples_.size()) {
    std::ranges::rotate(samples_, samples_.begin() + 1);
    --count_;
  }
  samples_[count_++] = now;
  const double speed = frame.ball->velocity.norm();
  if (speed < no_ball_is_faster) fastest_ = std::max(fastest_, speed);
  if (reported_ || count_ < frames_needed || speed < filter_agrees * max_speed_ || !too_fast(now)) return {};
  reported_ = true;

  world::BotKickedBallTooFast kick{{}, place_, fastest_};
  if (after_restart_ && state.kicker && state.kick_position) {
    kick.by = *state.kicker;
    kick.location = *state.kick_position;
  } else if (const auto touch = last_touch(frame, state, frame.time);
             touch && began_ - touch->time < recent_touch) {
    kick.by = touch->robot;
    kick.location = touch->position;
  } else if (nearest_) {
    kick.by = *nearest_;
  } else {
    return {};  // nobody there to blame: no ball of this game
  }
  return {{began_, kick}};
}

}  // namespace detectors
