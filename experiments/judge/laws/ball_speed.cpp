#include "experiments/judge/laws/ball_speed.h"

namespace judge {

void BallSpeed::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const auto* last = moment.touches.last_at(moment.now.time);
  const auto touch = last ? std::optional(last->touch) : std::nullopt;
  if (touch != touch_ || moment.by_hand) {
    finish(moment, out);
    touch_ = moment.by_hand ? std::nullopt : touch;
  }
  if (!touch_) return;
  double speed = moment.now.ball.velocity.norm();
  for (const truth::Kick& kick : moment.now.kicks) speed = std::max(speed, kick.velocity.norm());
  if (speed > fastest_.value) {
    fastest_.value = speed;
    fastest_.time = moment.touches[*touch_].end;
    fastest_.by = moment.touches[*touch_].robot;
    fastest_.place = moment.touches[*touch_].place;
  }
  in_play_ = in_play_ || moment.in_play();
  if (!moment.in_play() && in_play_) finish(moment, out);
}

void BallSpeed::finish(const Moment& moment, std::vector<TrueEvent>& out) {
  if (in_play_) {
    fastest_.event = Event::BallTooFast;
    fastest_.margin = (fastest_.value - moment.rules.max_ball_speed) / moment.bands.speed;
    report(out, fastest_);
  }
  fastest_ = {};
  in_play_ = false;
  touch_.reset();
}

}  // namespace judge
