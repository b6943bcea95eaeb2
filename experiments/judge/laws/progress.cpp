#include "experiments/judge/laws/progress.h"

namespace judge {
namespace {

constexpr world::Duration window = std::chrono::seconds{1};

}  // namespace

void Progress::watch(const Moment& moment, bool goalie_holds, bool ball_is_out, std::vector<TrueEvent>& out) {
  if (!moment.in_play() && near_.since &&
      moment.now.time - std::min(*near_.since, *nominal_.since) >= moment.rules.stuck_time - window) {
    // The referee tells it in whole seconds.
    out.push_back(
        {.event = Event::NoProgress, .time = moment.now.time, .margin = -0.5, .place = moment.ball()});
  }
  if (!moment.in_play() || moment.entered || moment.by_hand) {
    places_.clear();
    nominal_ = near_ = {};
    if (!moment.in_play()) return;
  }
  const world::Time now = moment.now.time;
  if (!nominal_.since || goalie_holds) nominal_ = {now, 0};
  if (!near_.since || goalie_holds) near_ = {now, 0};
  places_.emplace_back(now, moment.ball());
  while (places_.size() > 1 && places_[1].first + window <= now) places_.pop_front();
  if (!ball_is_out) out_.reset();
  if (out_) out[*out_].until = now;
  const double moved = ball_is_out ? 0 : (moment.ball() - places_.front().second).norm();

  const double limit = moment.rules.stuck_distance;
  const double near_limit = limit + near_bands * moment.bands.length;
  const double lasted = world::seconds(now - *near_.since);
  const double in_time = (lasted - world::seconds(moment.rules.stuck_time)) / moment.bands.time;
  if (moved >= near_limit && in_time < 0) {
    report(out, {.event = Event::NoProgress,
                 .time = now,
                 .margin = in_time,
                 .value = lasted,
                 .place = moment.ball()});
  }

  nominal_.best = std::max(nominal_.best, moved);
  near_.best = std::max(near_.best, moved);
  if (moved >= limit) nominal_ = {now, 0};
  if (moved >= near_limit) near_ = {now, 0};

  TrueEvent event{.event = Event::NoProgress, .time = now, .place = moment.ball()};
  if (now - *nominal_.since >= moment.rules.stuck_time) {
    event.value = nominal_.best;
    event.margin = std::max((limit - nominal_.best) / moment.bands.length, 1e-9);
    out.push_back(event);
    if (ball_is_out) out_ = out.size() - 1;
    nominal_ = near_ = {now, 0};
  } else if (now - *near_.since >= moment.rules.stuck_time) {
    event.value = near_.best;
    event.margin = std::min((limit - near_.best) / moment.bands.length, -1e-9);
    report(out, event);
    near_ = {now, 0};
  }
}

}  // namespace judge
