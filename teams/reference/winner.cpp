#include "teams/reference/winner.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/ball_handling.h"
#include "teams/skills/steer.h"

namespace reference {
namespace {

// [s] A choice stands this long unless the ball is lost; 10 Hz is often enough (reference "football", 2.8).
constexpr double rethink = 0.1;

double nearest_opponent(const kit::View& view, const Vector2d& point) {
  double nearest = 9;
  for (const kit::Robot& robot : view.opponents) nearest = std::min(nearest, (robot.position - point).norm());
  return nearest;
}

// A robot of theirs directly in front of the dribbler takes every flat ball.
bool blocked_in_front(const kit::View& view, const kit::Robot& robot) {
  const Vector2d ahead = world::direction(robot.orientation);
  for (const kit::Robot& other : view.opponents) {
    const Vector2d to = other.position - robot.position;
    const double forward = to.dot(ahead);
    const double beside = std::abs(ahead.x() * to.y() - ahead.y() * to.x());
    if (forward > 0 && forward < 0.5 && beside < 0.1) return true;
  }
  return false;
}

}  // namespace

std::optional<int> Winner::receiver(const kit::View& view) {
  if (!pass_) return {};
  if (view.time > pass_->until || kit::find(view.own, pass_->receiver) == nullptr ||
      view.ball.velocity.norm() < 0.3) {
    pass_.reset();
    return {};
  }
  return pass_->receiver;
}

void Winner::choose(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                    const KickRules& rules, const Parameters& parameters) {
  if (robot_ != robot.number) {
    robot_ = robot.number;
    choice_.reset();
    dribble_start_.reset();
    chosen_at_ = -1;
  }
  if (choice_ && view.time - chosen_at_ < rethink) return;
  choice_ = choose_kick(view, situation, robot.number, rules, parameters, choice_);
  chosen_at_ = view.time;
}

skills::Order Winner::play(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                           const KickRules& rules, const Parameters& parameters) {
  choose(view, situation, robot, rules, parameters);
  const kit::Ball& ball = view.ball;
  const bool holds = kit::holds_ball(robot, ball, view.field().ball_radius);
  if (holds) {
    if (!dribble_start_ || view.time - last_contact_ > 0.2) {
      dribble_start_ = ball.position;
      holding_since_ = view.time;
    }
    last_contact_ = view.time;
  }

  skills::Order order;
  const double speed = ball.velocity.norm();
  const Vector2d to_ball = ball.position - robot.position;
  const bool rests = speed < 0.6;
  if (rules.must_kick) {
    const double speed_of_kick = choice_->kind == Kick::Kind::Dribble ? 3.0 : choice_->speed;
    order = skills::approach_and_kick(view, robot, choice_->direction, speed_of_kick, choice_->angle,
                                      choice_->tolerance);
    order.why = "free kick";
  } else if (holds) {
    order = with_ball(view, situation, robot, parameters);
  } else if (!rests && to_ball.norm() > 0.25) {
    order = skills::receive(view, robot, situation.model);
  } else {
    // It rests or rolls slowly. Round it only when there is time or little to round.
    const double off = std::abs(world::wrap_angle(world::angle_of(to_ball) - choice_->direction));
    const bool time_to_round = situation.their_time > situation.meetings[robot.number].time + 0.3 + 0.5 * off;
    if (choice_->kind != Kick::Kind::Dribble && (off < 0.5 || time_to_round)) {
      order = skills::approach_and_kick(view, robot, choice_->direction, choice_->speed, choice_->angle,
                                        choice_->tolerance);
    } else {
      order = skills::capture(view, robot, situation.model);
    }
  }
  if (order.kick_speed > 0 && choice_->kind == Kick::Kind::Pass && to_ball.norm() < 0.2) {
    pass_ = PassUnderWay{choice_->receiver, view.time + 2.0};
  }
  return order;
}

skills::Order Winner::with_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                                const Parameters& parameters) {
  const kit::Ball& ball = view.ball;
  const double carried = (ball.position - *dribble_start_).norm();
  const double held = view.time - holding_since_;
  const bool pressed = nearest_opponent(view, ball.position) < 0.25;
  const bool let_go = carried > parameters.dribble_distance || held > 4.0 || (pressed && held > 0.6);

  const Kick& kick = *choice_;
  if (held < 0.1) {
    // Just arrived: let the bar take hold before anything turns.
    skills::Order order;
    order.why = "hold";
    order.dribble = true;
    order.heading = robot.orientation;
    order.robot_margin = 0;
    order.velocity = 0.1 * world::direction(robot.orientation);
    if (std::abs(world::wrap_angle(kick.direction - robot.orientation)) < kick.tolerance) {
      order.kick_speed = kick.speed;
      order.kick_angle = kick.angle;
    }
    return order;
  }
  if (let_go) {
    // Away with it along the present heading, unless that is towards the own goal: then it is only released.
    skills::Order order;
    order.why = "let go";
    order.heading = robot.orientation;
    order.robot_margin = 0;
    order.velocity = Vector2d::Zero();
    const Vector2d ahead = world::direction(robot.orientation);
    const bool home = ahead.x() < -0.2 && ball.position.x() < 0;
    if (home) {
      order.velocity = -0.5 * ahead;
      return order;
    }
    const bool chip = blocked_in_front(view, robot);
    order.kick_speed = chip ? 3.5 : 2.5;
    order.kick_angle = chip ? M_PI / 4 : 0;
    order.velocity = 0.3 * ahead;
    return order;
  }
  if (kick.kind != Kick::Kind::Dribble) {
    return skills::turn_and_kick(view, robot, kick.direction, kick.speed, kick.angle, kick.tolerance);
  }
  // Carry it: turn towards the goal, then drive slowly enough that the bar keeps the ball.
  const double error = world::wrap_angle(kick.direction - robot.orientation);
  if (std::abs(error) > 0.35) return skills::turn_and_kick(view, robot, kick.direction, 0, 0, 0.05);
  skills::Order order;
  order.why = "dribble";
  order.heading = kick.direction;
  order.max_turn = 2.0;
  order.dribble = true;
  order.robot_margin = 0.05;
  order.velocity = world::direction(robot.orientation) * std::min(1.0, 0.4 + held);
  (void)situation;
  return order;
}

}  // namespace reference
