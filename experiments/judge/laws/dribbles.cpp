#include "experiments/judge/laws/dribbles.h"

namespace judge {
namespace {

constexpr double separation = 0.02;  // [m]
constexpr world::Duration after_stop = std::chrono::milliseconds{500};

}  // namespace

void Dribbles::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  if (moment.in_play()) {
    if (moment.entered) dribbles_ = {};
    stopped_.reset();
  } else if (!stopped_) {
    stopped_ = moment.now.time;
  }
  const bool over = moment.by_hand || (stopped_ && moment.now.time >= *stopped_ + after_stop);
  const world::Vector2d ball = moment.ball();
  for (const truth::Robot& robot : moment.now.robots) {
    const std::size_t n = slot(robot.id);
    std::optional<Dribble>& dribble = dribbles_[n];
    ids_[n] = robot.id;
    if (dribble && (over || gap(moment.rules.field, robot, moment.now.ball) > separation)) {
      finish(moment, n, out);
      continue;
    }
    if (!dribble) {
      const bool touches = std::ranges::any_of(moment.touches.fresh(), [&](const auto& contact) {
        return moment.touches[contact.touch].robot == robot.id;
      });
      if (moment.in_play() && touches) dribble = Dribble{ball};
      continue;
    }
    const double distance = (ball - dribble->start).norm();
    if (distance > dribble->farthest) dribble->farthest = distance;
    if (!dribble->passed && distance > moment.rules.max_dribble) {
      dribble->passed = moment.now.time;
      dribble->place = ball;
    }
  }
}

void Dribbles::finish(const Moment& moment, std::size_t robot, std::vector<TrueEvent>& out) {
  const Dribble& dribble = *dribbles_[robot];
  const double beyond = dribble.farthest - moment.rules.max_dribble;
  report(out, {.event = Event::DribbledTooFar,
               .time = dribble.passed.value_or(moment.now.time),
               .margin = beyond / moment.bands.length,
               .value = dribble.farthest,
               .by = ids_[robot],
               .place = dribble.passed ? dribble.place : moment.ball()});
  dribbles_[robot].reset();
}

}  // namespace judge
