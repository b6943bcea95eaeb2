#include "experiments/judge/laws/laws.h"

namespace judge {
namespace {

/// Whether the ball got there by itself: no farther than its greater speed takes it, and as much again as
/// robots push and physics part bodies.
bool put_there(const truth::Frame& before, const truth::Frame& now) {
  constexpr double pushed = 0.05;  // [m]
  double speed = std::max(before.ball.velocity.norm(), now.ball.velocity.norm());
  for (const truth::Kick& kick : now.kicks) speed = std::max(speed, kick.velocity.norm());
  const double way = (now.ball.position - before.ball.position).norm();
  return way > speed * world::seconds(now.time - before.time) + pushed;
}

}  // namespace

void Laws::watch(const truth::Frame& frame, const world::GameState& state, bool ball_seen) {
  if (!before_) before_ = frame;
  const bool entered = state.location != location_ || state.location_time != location_time_;
  location_ = state.location;
  location_time_ = state.location_time;
  by_hand_ = put_there(*before_, frame);
  touches_.add(frame, state.location == world::Location::GameOn);

  const Moment moment{.now = frame,
                      .before = *before_,
                      .state = state,
                      .entered = entered,
                      .by_hand = by_hand_,
                      .ball_seen = ball_seen,
                      .touches = touches_,
                      .rules = rules_,
                      .bands = bands_};
  exits_.watch(moment, events_);
  ball_speed_.watch(moment, events_);
  dribbles_.watch(moment, events_);
  kicks_.watch(moment, events_);
  areas_.watch(moment, events_);
  keeper_holds_.watch(moment, events_);
  contacts_.watch(moment, events_);
  stops_.watch(moment, events_);
  robots_.watch(moment, events_);
  progress_.watch(moment, keeper_holds_.holder().has_value(), events_);
  settling_.watch(moment, events_);
  before_ = frame;
}

}  // namespace judge
