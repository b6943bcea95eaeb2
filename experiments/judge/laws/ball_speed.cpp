#include "experiments/judge/laws/ball_speed.h"

#include <algorithm>

namespace judge {
namespace {

constexpr double told_after = 0.2;  // [s] of flight, a speed is told to within its band (Bands)

}  // namespace

void BallSpeed::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const auto* last = moment.touches.last_at(moment.now.time);
  const auto touch = last ? std::optional(last->touch) : std::nullopt;
  if (touch != touch_ || moment.by_hand) {
    finish(moment, out);
    touch_ = moment.by_hand ? std::nullopt : touch;
  }
  if (!touch_) return;
  double speed = moment.now.ball.velocity.norm();
  for (const truth::Kick& kick : moment.now.kicks) {
    const auto stopped_it = [&](const TrueTouches::Contact& contact) {
      return contact.time >= kick.time && moment.touches[contact.touch].robot != kick.robot;
    };
    const auto& fresh = moment.touches.fresh();
    const auto next = std::ranges::find_if(fresh, stopped_it);
    if (next == fresh.end()) {
      speed = std::max(speed, kick.velocity.norm());
    } else if (moment.in_play()) {  // in the same tick: it flew from one robot to the other
      TrueEvent jammed;
      jammed.time = kick.time;
      jammed.value = kick.velocity.norm();
      jammed.by = kick.robot;
      jammed.place = moment.ball();
      tell(jammed, world::seconds(next->time - kick.time), moment.rules, moment.bands, out);
    }
  }
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
  if (in_play_ && touch_) {
    const auto* next = moment.touches.last_at(moment.now.time);
    const bool touched = next != nullptr && next->touch != *touch_;
    const world::Time until = touched ? moment.touches[next->touch].begin : moment.now.time;
    const double flight = world::seconds(until - moment.touches[*touch_].end);
    tell(fastest_, flight, moment.rules, moment.bands, out);
  }
  fastest_ = {};
  in_play_ = false;
  touch_.reset();
}

void BallSpeed::tell(TrueEvent fastest, double flight, const world::RuleSet& rules, const Bands& bands,
                     std::vector<TrueEvent>& out) {
  const double beyond = fastest.value - rules.max_ball_speed;
  const double seen = beyond > 0 ? std::clamp(flight / told_after, 0.0, 1.0) : 1.0;
  fastest.event = Event::BallTooFast;
  fastest.margin = std::max(beyond * seen, std::min(beyond, 1e-9)) / bands.speed;
  report(out, fastest);
}

void BallSpeed::finish(const world::RuleSet& rules, const Bands& bands, std::vector<TrueEvent>& out) {
  if (in_play_ && touch_) tell(fastest_, told_after, rules, bands, out);
  in_play_ = false;
}

}  // namespace judge
