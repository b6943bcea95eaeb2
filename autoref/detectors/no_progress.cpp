#include "autoref/detectors/no_progress.h"

#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr world::Duration window = std::chrono::seconds{1};

}  // namespace

Events NoProgress::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (!progress_ || (goalie_may_hold_ && keeper_with_ball(field_, frame, state))) progress_ = frame.time;
  if (const auto ball = observed_ball(frame)) {
    const bool moved = place_ && (*ball - *place_).norm() >= distance_;
    if (moved) progress_ = frame.time;
    if (!place_ || moved || frame.time - *sample_time_ >= window) {
      place_ = *ball;
      sample_time_ = frame.time;
    }
  }
  const world::Duration waited = frame.time - *progress_;
  if (waited < limit_) return {};
  progress_ = frame.time;  // once per wait
  return {{frame.time, world::NoProgressInGame{place_.value_or(world::Vector2d::Zero()), waited}}};
}

}  // namespace detectors
