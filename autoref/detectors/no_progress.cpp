#include "autoref/detectors/no_progress.h"

#include <algorithm>
#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr world::Duration window = std::chrono::seconds{1};
constexpr world::Duration apart = std::chrono::milliseconds{15};

/// Where it was seen, or where a robot has it that hides it.
std::optional<world::Vector2d> known_ball(const world::TrackedFrame& frame) {
  if (!frame.ball) return std::nullopt;
  if (!frame.ball->observed && std::ranges::none_of(frame.robots, &world::TrackedRobot::ball_in_reach)) {
    return std::nullopt;
  }
  return on_ground(*frame.ball);
}

}  // namespace

Events NoProgress::update(const world::TrackedFrame& frame, const world::GameState& state) {
  if (!progress_ || (goalie_may_hold_ && keeper_with_ball(field_, frame, state))) progress_ = frame.time;
  if (const auto ball = known_ball(frame)) {
    const auto oldest = [this] { return samples_[(next_ + samples_.size() - count_) % samples_.size()]; };
    while (count_ > 1 && frame.time - oldest().time > window) --count_;
    if (count_ > 0 && (*ball - oldest().place).norm() >= distance_) progress_ = frame.time;
    const Sample& newest = samples_[(next_ + samples_.size() - 1) % samples_.size()];
    if (count_ == 0 || frame.time - newest.time >= apart) {
      samples_[next_] = {frame.time, *ball};
      next_ = (next_ + 1) % samples_.size();
      count_ = std::min(count_ + 1, samples_.size());
    }
  }
  const world::Duration waited = frame.time - *progress_;
  if (waited < limit_) return {};
  progress_ = frame.time;  // once per wait
  const world::Vector2d place = frame.ball ? on_ground(*frame.ball) : world::Vector2d::Zero();
  return {{frame.time, world::NoProgressInGame{place, waited}}};
}

}  // namespace detectors
