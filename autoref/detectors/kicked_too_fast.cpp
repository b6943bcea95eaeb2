#include "autoref/detectors/kicked_too_fast.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr double tolerance = 1.02;
constexpr int frames_needed = 4;
constexpr double no_ball_is_faster = 12.0;  // [m/s]
constexpr double least_way = 0.5;           // of the way that the limit would take it
constexpr world::Duration recent_touch = std::chrono::milliseconds{300};

}  // namespace

Events KickedTooFast::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto ball = observed_ball(frame);
  if (!ball) return {};
  const double speed = frame.ball->velocity.norm();

  if (speed <= tolerance * max_speed_ || speed > no_ball_is_faster) {
    const world::TrackedRobot* nearest = nearest_robot(frame, *ball);
    before_ = Sample{frame.time, *ball, nearest ? std::optional{nearest->id} : std::nullopt};
    began_.reset();
    count_ = 0;
    fastest_ = 0;
    reported_ = false;
    return {};
  }
  if (count_ == 0) began_ = before_;
  ++count_;
  fastest_ = std::max(fastest_, speed);
  if (reported_ || count_ < frames_needed || !began_) return {};
  const double way = (*ball - began_->ball).norm();
  if (way < least_way * max_speed_ * world::seconds(frame.time - began_->time)) return {};
  reported_ = true;

  world::BotKickedBallTooFast kick{{}, began_->ball, fastest_};
  if (state.last_touch && began_->time - state.last_touch->time < recent_touch) {
    kick.by = state.last_touch->robot;
    kick.location = state.last_touch->position;
  } else if (began_->nearest) {
    kick.by = *began_->nearest;
  } else {
    return {};  // nobody there to blame: no ball of this game
  }
  return {{began_->time, kick}};
}

}  // namespace detectors
