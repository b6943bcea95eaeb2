#include "experiments/judge/laws/dribbles.h"

namespace judge {
namespace {

constexpr double separation = 0.02;                                     // [m]
constexpr double lenient_separation = 0.06;                             // [m] a band more
constexpr double dribbler_height = 0.05;                                // [m] what it reaches
constexpr world::Duration after_stop = std::chrono::milliseconds{200};  // and the laws' 0.3 s

}  // namespace

void Dribbles::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  if (moment.in_play()) {
    if (moment.entered) robots_ = {};
    stopped_.reset();
  } else if (!stopped_) {
    stopped_ = moment.now.time;
  }
  const bool over = moment.by_hand || (stopped_ && moment.now.time >= *stopped_ + after_stop);
  const bool high = moment.now.ball.position.z() - moment.rules.field.ball_radius > dribbler_height;
  for (const truth::Robot& robot : moment.now.robots) {
    OfRobot& its = robots_[slot(robot.id)];
    const double apart = over || high ? 1 : gap(moment.rules.field, robot, moment.now.ball);
    if (its.strict && apart > separation) finish(moment, robot.id, out);
    if (its.lenient && apart > lenient_separation) {
      const Dribble& lenient = *its.lenient;
      if (lenient.passed ? !its.strictly_too_far : lenient.close && !its.strictly_close) {
        report(out, {.event = Event::DribbledTooFar,
                     .time = lenient.passed.value_or(*lenient.close),
                     .until = moment.now.time,
                     .margin = -0.5,
                     .value = lenient.farthest,
                     .by = robot.id,
                     .place = lenient.place});
      }
      its.lenient.reset();
      its.strictly_too_far = its.strictly_close = false;
    }
    watch(moment, robot, apart, its.strict);
    watch(moment, robot, apart, its.lenient);
  }
}

void Dribbles::watch(const Moment& moment, const truth::Robot& robot, double apart,
                     std::optional<Dribble>& dribble) {
  const world::Vector2d ball = moment.ball();
  if (!dribble) {
    const bool touches = std::ranges::any_of(moment.touches.fresh(), [&](const auto& contact) {
      return moment.touches[contact.touch].robot == robot.id;
    });
    if (moment.in_play() && touches && apart <= separation) dribble = Dribble{ball};
    return;
  }
  const double distance = (ball - dribble->start).norm();
  dribble->farthest = std::max(dribble->farthest, distance);
  if (!dribble->close && distance > moment.rules.max_dribble - moment.bands.length) {
    dribble->close = moment.now.time;
  }
  if (!dribble->passed && distance > moment.rules.max_dribble) {
    dribble->passed = moment.now.time;
    dribble->place = ball;
  }
}

void Dribbles::finish(const Moment& moment, world::RobotId robot, std::vector<TrueEvent>& out) {
  OfRobot& its = robots_[slot(robot)];
  const Dribble& dribble = *its.strict;
  its.strictly_too_far = its.strictly_too_far || dribble.passed;
  its.strictly_close = its.strictly_close || dribble.close;
  report(out, {.event = Event::DribbledTooFar,
               .time = dribble.passed.value_or(moment.now.time),
               .margin = (dribble.farthest - moment.rules.max_dribble) / moment.bands.length,
               .value = dribble.farthest,
               .by = robot,
               .place = dribble.passed ? dribble.place : moment.ball()});
  its.strict.reset();
}

}  // namespace judge
