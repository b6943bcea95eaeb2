#include "autoref/detectors/keeper_held_ball.h"

#include <chrono>

#include "autoref/detectors/ball.h"

namespace detectors {
namespace {

constexpr world::Duration separation = std::chrono::milliseconds{500};

}  // namespace

Events KeeperHeldBall::update(const world::TrackedFrame& frame, const world::GameState& state) {
  const auto holder = keeper_with_ball(field_, frame, state);
  if (holder) {
    if (!since_ || holder_ != holder) {
      since_ = frame.time;
      holder_ = holder;
      reported_ = false;
    }
    last_ = frame.time;
  } else if (since_ && frame.time - last_ > separation) {
    since_.reset();
    reported_ = false;
  }
  if (!since_ || reported_ || last_ - *since_ <= limit_) return {};  // while it has the ball, not after
  reported_ = true;
  const world::KeeperHeldBall held{*holder_, on_ground(*frame.ball), last_ - *since_};
  return {{frame.time, held}};
}

}  // namespace detectors
