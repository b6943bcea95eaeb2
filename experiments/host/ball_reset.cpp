#include "experiments/host/ball_reset.h"

namespace host {

std::optional<world::Vector2d> BallReset::update(const std::optional<world::Vector2d>& wish,
                                                 const world::GameState& state, engine::Engine& engine) {
  const world::Time now = engine.time();
  if (wish) {
    // The same wish again does not start the waiting anew.
    const world::Time since = wish_ && wish_->spot == *wish ? wish_->since : now;
    wish_ = Wish{*wish, since};
  }
  if (state.location == world::Location::GameOn) wish_.reset();  // too late: the ball is in play
  if (!wish_ || now < state.command_time + delay) return std::nullopt;

  if (!engine.spot_is_free(wish_->spot, clearance)) {
    if (now < wish_->since + patience) return std::nullopt;
    engine.push_robots_out(wish_->spot, clearance);
  }
  const world::Vector2d spot = wish_->spot;
  engine.place_ball(spot);
  wish_.reset();
  return spot;
}

}  // namespace host
