#include "experiments/judge/laws/stops.h"

namespace judge {
namespace {

constexpr double at_rest = 0.05;  // [m] a ball that has not moved farther lies

}  // namespace

void Stops::begin(const Moment& moment) {
  stop_ = true;
  lies_at_.reset();
  for (OfRobot& robot : robots_) {
    robot.speed = {Window(moment.rules.stop_violation)};
    robot.near = {Window(moment.rules.stop_grace)};
    robot.way = {Window(moment.rules.stop_grace)};
  }
}

void Stops::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const bool stop = is_stop(moment.state);
  if (stop_ && (!stop || moment.entered)) finish(out);
  if (stop && !stop_) begin(moment);
  if (!stop) return;

  const world::Field& field = moment.rules.field;
  const world::Vector2d ball = moment.ball();
  const bool lies = lies_at_ && (ball - *lies_at_).norm() <= at_rest && !moment.by_hand;
  if (!lies) lies_at_ = ball;
  const auto& place = moment.state.reset_position;
  const bool to_be_placed = place && (ball - *place).norm() > moment.rules.placement_tolerance;
  const bool graced = moment.now.time - moment.state.command_time >= moment.rules.stop_grace;

  for (const truth::Robot& robot : moment.now.robots) {
    OfRobot& its = robots_[slot(robot.id)];
    if (!graced) {
      its.speed.window.clear();
    } else {
      its.speed.window.add(moment.now.time, robot.velocity.norm());
      if (its.speed.window.full()) {
        note(moment, Event::TooFastInStop, robot, its.speed.window.least() - moment.rules.stop_speed,
             moment.bands.speed, its.speed);
      }
    }
    if (!lies) its.near.window.clear();
    its.near.window.add(moment.now.time, (robot.position - ball).norm() - field.robot_radius);
    if (its.near.window.full()) {
      note(moment, Event::TooNearInStop, robot, moment.rules.stop_distance - its.near.window.greatest(),
           moment.bands.length, its.near);
    }
    if (!to_be_placed) {
      its.way.window.clear();
      continue;
    }
    its.way.window.add(moment.now.time, world::distance({ball, *place}, robot.position) - field.robot_radius);
    if (its.way.window.full()) {
      note(moment, Event::InterferedPlacement, robot, moment.rules.stop_distance - its.way.window.greatest(),
           moment.bands.length, its.way);
    }
  }
}

void Stops::note(const Moment& moment, Event event, const truth::Robot& robot, double beyond, double band,
                 Watched& watched) const {
  const double margin = beyond / band;
  if (watched.worst && margin > 0) watched.worst->until = moment.now.time;
  if (watched.worst && watched.worst->margin >= margin) return;
  // The time is that of the first moment beyond the limit, or of the nearest one.
  const world::Time time = watched.passed ? watched.worst->time : moment.now.time;
  watched.passed = watched.passed || margin > 0;
  auto clear = watched.worst ? watched.worst->clear : std::nullopt;
  if (!clear && margin >= 1) clear = moment.now.time;
  watched.worst = TrueEvent{.event = event,
                            .time = time,
                            .until = moment.now.time,
                            .clear = clear,
                            .margin = margin,
                            .value = beyond,
                            .by = robot.id,
                            .place = robot.position};
}

void Stops::finish(std::vector<TrueEvent>& out) {
  for (OfRobot& robot : robots_) {
    for (Watched* watched : {&robot.speed, &robot.near, &robot.way}) {
      if (watched->worst) report(out, *watched->worst);
      watched->worst.reset();
    }
  }
  stop_ = false;
}

}  // namespace judge
