#include "experiments/judge/laws/laws.h"

namespace judge {

using world::Location;

namespace {

constexpr world::Duration watched_on = std::chrono::milliseconds{300};  // the window of matching

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
  touches_.add(frame, state.location == Location::GameOn);

  if (state.location == Location::GameOn) {
    play_ = state;
  } else if (play_ && (by_hand_ || frame.time > state.location_time + watched_on ||
                       state.location == Location::Setup)) {
    play_.reset();
  }
  const Moment moment = at(frame, state, entered, ball_seen);
  const std::size_t first_of_kicks = events_.size();
  kicks_.watch(moment, events_);
  const std::size_t end_of_kicks = events_.size();
  stops_.watch(moment, events_);
  settling_.watch(moment, events_);

  const bool after_whistle = play_ && state.location != Location::GameOn;
  const Moment play = at(frame, play_ ? *play_ : state, entered && !after_whistle, ball_seen);
  const std::size_t first = events_.size();
  ball_speed_.watch(play, events_);
  watch_play(play);
  mark_late(first, state);
  for (std::size_t n = first_of_kicks; n < end_of_kicks; ++n) {
    TrueEvent& event = events_[n];
    const bool ball_was_out = exits_.out_since() && event.time > *exits_.out_since();
    if (event.event == Event::DoubleTouch && state.location != Location::Setup && ball_was_out)
      event.late = true;
  }
  before_ = frame;
  state_ = state;
}

Moment Laws::at(const truth::Frame& now, const world::GameState& state, bool entered, bool ball_seen) const {
  return {.now = now,
          .before = *before_,
          .state = state,
          .entered = entered,
          .by_hand = by_hand_,
          .ball_seen = ball_seen,
          .touches = touches_,
          .rules = rules_,
          .bands = bands_};
}

void Laws::watch_play(const Moment& play) {
  exits_.watch(play, events_);
  dribbles_.watch(play, events_);
  areas_.watch(play, events_);
  keeper_holds_.watch(play, events_);
  contacts_.watch(play, events_);
  robots_.watch(play, events_);
  progress_.watch(play, keeper_holds_.holder().has_value(), exits_.out_since().has_value(), events_);
}

void Laws::mark_late(std::size_t first, const world::GameState& state) {
  const bool stopped = state.location != Location::GameOn;
  for (std::size_t n = first; n < events_.size(); ++n) {
    TrueEvent& event = events_[n];
    const bool leaves = event.event == Event::Exit || event.event == Event::Goal ||
                        event.event == Event::ChippedGoal || event.event == Event::AimlessKick;
    event.late = stopped && event.time > state.location_time;
    if (!leaves && exits_.out_since()) event.late = event.late || event.time > *exits_.out_since();
  }
}

void Laws::finish() {
  if (before_) {
    world::GameState over = state_;
    over.location = Location::GameOff;
    by_hand_ = true;  // what moves now is no matter
    const Moment end = at(*before_, over, true, false);
    const std::size_t first = events_.size();
    watch_play(end);
    mark_late(first, state_);
  }
  exits_.finish(bands_, events_);
  ball_speed_.finish(rules_, bands_, events_);
  stops_.finish(events_);
}

}  // namespace judge
