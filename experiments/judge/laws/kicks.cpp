#include "experiments/judge/laws/kicks.h"

namespace judge {

using world::Vector2d;

namespace {

constexpr world::Duration patience = std::chrono::milliseconds{300};  // after SETUP was left

}  // namespace

void Kicks::watch(const Moment& moment, std::vector<TrueEvent>& out) {
  const bool setup = moment.in(world::Location::Setup);
  if (setup && (moment.entered || moment.by_hand)) {
    restart_ = Restart{moment.ball(), moment.state.kick_team, moment.state.is_kickoff};
    second_.reset();
    left_.reset();
  }
  if (!setup && restart_ && !left_) left_ = moment.now.time;
  if (moment.by_hand && !setup) restart_.reset();
  if (restart_) take(moment, out);
  // The referee may have been early: it is watched for a little longer.
  if (!moment.in(world::Location::GameOff))
    stopped_.reset();
  else if (!stopped_)
    stopped_ = moment.now.time;
  if (second_ && stopped_ && (moment.by_hand || moment.now.time >= *stopped_ + patience)) {
    end_second(out);
  }
  const std::size_t first = out.size();
  if (second_) watch_second(moment, out);
  for (std::size_t n = first; n < out.size(); ++n) out[n].late = stopped_ && out[n].time > *stopped_;
}

void Kicks::take(const Moment& moment, std::vector<TrueEvent>& out) {
  Restart& restart = *restart_;
  const double travel = (moment.ball() - restart.place).norm();
  for (const TrueTouches::Contact& contact : moment.touches.fresh()) {
    if (!restart.first_touch) restart.first_touch = contact.touch;
    if (!restart.taken) restart.robots = moment.before.robots;
  }
  if (!restart.taken && travel > moment.rules.kick_travel) {
    const double before = (moment.before.ball.position.head<2>() - restart.place).norm();
    const double share = before < travel ? (moment.rules.kick_travel - before) / (travel - before) : 1;
    restart.taken.emplace();
    restart.taken->event = Event::KickTaken;
    restart.taken->time =
        moment.before.time + world::from_seconds(std::clamp(share, 0.0, 1.0) * world::tick_length);
    restart.taken->place = restart.place;
    if (restart.first_touch) {
      restart.taken->by = moment.touches[*restart.first_touch].robot;
      // A kicker that nudged the ball and then kicked it is at the touch that put it in play.
      const auto* last = moment.touches.last_at(moment.now.time);
      if (moment.touches[last->touch].robot == *restart.taken->by) {
        second_ = Second{*restart.taken->by, last->touch, restart.place};
      }
    }
    look_around(moment, out);
  }
  restart.farthest = std::max(restart.farthest, travel);
  const bool over = restart.taken ? moment.now.time >= restart.taken->time + patience
                                  : left_ && moment.now.time >= *left_ + patience;
  if (!over) return;
  if (restart.taken) {
    restart.taken->value = restart.farthest;
    restart.taken->margin = (restart.farthest - moment.rules.kick_travel) / moment.bands.length;
    out.push_back(*restart.taken);
  }
  restart_.reset();
}

void Kicks::look_around(const Moment& moment, std::vector<TrueEvent>& out) const {
  const world::Field& field = moment.rules.field;
  const Restart& restart = *restart_;
  const world::Side attacked = world::other(world::defended_side(moment.state, restart.team));
  std::optional<TrueEvent> opponent, attacker, wrong_half;
  const auto keep = [&](std::optional<TrueEvent>& worst, Event event, const truth::Robot& robot,
                        double value) {
    if (worst && worst->value >= value) return;
    worst = TrueEvent{.event = event,
                      .time = restart.taken->time,
                      .margin = value / moment.bands.length,
                      .value = value,
                      .by = robot.id,
                      .place = robot.position};
  };
  for (const truth::Robot& robot : restart.robots.empty() ? moment.before.robots : restart.robots) {
    if (robot.id.team != restart.team) {
      const double distance = (robot.position - restart.place).norm() - field.robot_radius;
      keep(opponent, Event::OpponentNearBall, robot, moment.rules.opponent_distance - distance);
    } else if (robot.id != restart.taken->by) {
      const double distance =
          world::distance_to_defense_area(field, attacked, robot.position) - field.robot_radius;
      keep(attacker, Event::AttackerNearArea, robot, moment.rules.attacker_area_distance - distance);
    }
    if (restart.kickoff) {
      const double own = world::sign(world::defended_side(moment.state, robot.id.team));
      keep(wrong_half, Event::WrongHalf, robot, -robot.position.x() * own);
    }
  }
  for (const auto& worst : {opponent, attacker, wrong_half}) {
    if (worst) report(out, *worst);
  }
}

void Kicks::watch_second(const Moment& moment, std::vector<TrueEvent>& out) {
  Second& second = *second_;
  for (const TrueTouches::Contact& contact : moment.touches.fresh()) {
    const TrueTouch& touch = moment.touches[contact.touch];
    const bool same = contact.touch == second.first_touch;
    if (touch.robot != second.kicker || !same) {
      if (touch.robot == second.kicker) {
        second.nearly.reset();
        report(out, {.event = Event::DoubleTouch,
                     .time = touch.begin,
                     .margin = second.apart / moment.bands.length,
                     .value = second.apart,
                     .by = second.kicker,
                     .place = touch.place,
                     .ambiguous = touch.squeezed});
      }
      end_second(out);
      return;
    }
    const double pushed = (touch.place - second.place).norm() - moment.rules.kick_travel;
    if (pushed <= 0) continue;
    if (!second.pushed) {
      second.pushed = TrueEvent{.event = Event::DoubleTouch, .time = contact.time, .by = second.kicker};
    }
    second.pushed->place = touch.place;
    second.pushed->value = std::max(second.pushed->value, pushed);
    second.pushed->margin = second.pushed->value / moment.bands.length;
  }
  follow_ball(moment);
}

void Kicks::follow_ball(const Moment& moment) {
  Second& second = *second_;
  const truth::Robot* kicker = find_robot(moment.now, second.kicker);
  if (kicker == nullptr) return;
  const double between = gap(moment.rules.field, *kicker, moment.now.ball);
  second.apart = std::max(second.apart, between);
  const double margin = -std::max(between, 1e-9) / moment.bands.length;
  const bool returned = second.apart > near_bands * moment.bands.length && margin > -near_bands;
  if (!returned || (second.nearly && second.nearly->margin >= margin)) return;
  second.nearly = TrueEvent{.event = Event::DoubleTouch,
                            .time = moment.now.time,
                            .margin = margin,
                            .value = between,
                            .by = second.kicker,
                            .place = moment.ball()};
}

void Kicks::end_second(std::vector<TrueEvent>& out) {
  if (second_->pushed) {
    report(out, *second_->pushed);
  } else if (second_->nearly) {
    report(out, *second_->nearly);
  }
  second_.reset();
}

}  // namespace judge
