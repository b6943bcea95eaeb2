#include "teams/reference/winner.h"

#include <algorithm>
#include <cmath>

#include "teams/reference/reception.h"
#include "teams/reference/with_ball.h"
#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/receive.h"

namespace reference {
namespace {

// [s] A choice stands this long unless the ball is lost; 10 Hz is often enough (reference "football", 2.8).
constexpr double rethink = 0.1;
// [s] But at a restart, once it is at the ball: as long as going round it and kicking takes. The more the
// kicker has turned to one receiver, the sooner the ball would come to it, and the better the other looked.
constexpr double stands_by_it = 1.5;
constexpr double at_the_ball = 0.35;  // [m]

// A slow ball is gone to, a faster one is let come [m/s].
constexpr double slow_ball = 0.6;
// Hull to ball [m]: as near it may be touched, as far nobody takes it for one dribble (law 12; ours).
constexpr double in_touch = 0.02;
constexpr double out_of_touch = 0.05;
constexpr int ticks_out_of_touch = 3;
constexpr double letting_go_takes = 0.2;  // [s] until a ball pushed along with the hull is out of touch; ours
// [s] After letting go of the ball the robot goes round it, and does not take it again the shortest way.
constexpr double go_round_for = 1.2;

}  // namespace

std::optional<int> Winner::receiver(const kit::View& view) {
  if (!pass_) return {};
  const double speed = view.ball.velocity.norm();
  if (!pass_->kicked) {
    // Armed is not kicked: the ball may not have been there, or the kicker failed.
    if (view.time > pass_->armed_at + 0.3) pass_.reset();
    if (!pass_ || speed < 1.0 || view.ball.velocity.dot(pass_->direction) < 0.9 * speed) return {};
    pass_->kicked = true;
  }
  const kit::Robot* mate = kit::find(view.own, pass_->receiver);
  if (view.time > pass_->until || speed < 0.3 || mate == nullptr || mate->ball_contact) {
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
    redirect_.reset();
    released_at_ = -9;
    chosen_at_ = -1;
  }
  if (rules.given) {
    choice_ = rules.given;
    chosen_at_ = view.time;
    return;
  }
  const bool committed = rules.must_kick && (view.ball.position - robot.position).norm() < at_the_ball;
  if (choice_ && view.time - chosen_at_ < (committed ? stands_by_it : rethink)) return;
  choice_ = choose_kick(view, situation, robot.number, rules, parameters, choice_);
  chosen_at_ = view.time;
}

Vector2d Winner::HoldWatch::farthest_from(const Vector2d& ball) const {
  Vector2d farthest = ball;
  for (std::size_t i = 0; i < places; ++i) {
    if ((way[i] - ball).squaredNorm() > (farthest - ball).squaredNorm()) farthest = way[i];
  }
  return farthest;
}

void Winner::HoldWatch::go_on(const Vector2d& ball) {
  constexpr double step = 0.1;  // [m]
  if (places < way.size() && (places == 0 || (way[places - 1] - ball).norm() > step)) way[places++] = ball;
}

// Contact begins when the ball comes to the dribbler or to any side of the hull and ends when it is clearly
// away from the robot, as the laws count a dribble: a ball that only trembles at the bar, or rolls along the
// hull, is the same. Kept for every robot: the role may go to another and come back during one dribble.
void Winner::watch_the_holds(const kit::View& view) {
  const double ball_radius = view.field().ball_radius;
  for (const kit::Robot& robot : view.own) {
    HoldWatch& watch = holds_[robot.number];
    watch.now = kit::holds_ball(robot, view.ball, ball_radius);
    const double away = (view.ball.position - robot.position).norm() - robot.specs.radius - ball_radius;
    watch.ticks_apart = away > out_of_touch ? watch.ticks_apart + 1 : 0;
    if (watch.ticks_apart >= ticks_out_of_touch) watch.places = 0;
    const bool begins = watch.places == 0 && (watch.now || away < in_touch);
    if (begins || watch.places > 0) watch.go_on(view.ball.position);
    if (!watch.now) continue;
    if (begins || view.time - watch.last_contact > 0.2) watch.since = view.time;
    watch.last_contact = view.time;
  }
}

skills::Order Winner::play(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                           const KickRules& rules, const Parameters& parameters) {
  choose(view, situation, robot, rules, parameters);
  watch_the_holds(view);
  skills::Order order;
  if (rules.must_kick) {
    order = free_kick(view, robot);
  } else if (holds_[robot.number].now) {
    order = with_ball(view, situation, robot, parameters);
  } else {
    order = fetch(view, situation, robot, rules, parameters);
  }
  const Kick& now = *choice();
  if (order.kick_speed > 0 && now.kind == Kick::Kind::Pass &&
      (redirect_ || (view.ball.position - robot.position).norm() < 0.2)) {
    const double length = (now.target - view.ball.position).norm();
    pass_ = PassUnderWay{now.receiver, world::direction(now.direction), view.time,
                         view.time + 1.0 + length / 1.5};
  }
  return order;
}

// The ball must not move before it is kicked: another touch would be the second.
skills::Order Winner::free_kick(const kit::View& view, const kit::Robot& robot) const {
  const double speed = choice_->kind == Kick::Kind::Dribble ? 3.0 : choice_->speed;
  skills::Order order =
      skills::approach_and_kick(view, robot, choice_->direction, speed, choice_->angle, choice_->tolerance);
  order.why = "free kick";
  order.dribble = false;
  const double gap =
      (view.ball.position - robot.position).norm() - skills::reach_of(robot, view.field().ball_radius);
  if (order.velocity && order.kick_speed == 0 && gap < 0.045) {
    // Aligned it is not yet: sideways and back only.
    const Vector2d aim = world::direction(choice_->direction);
    *order.velocity -= aim * std::max(order.velocity->dot(aim), 0.0);
  }
  return order;
}

skills::Order Winner::with_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                                const Parameters& parameters) {
  redirect_.reset();
  const HoldWatch& watch = holds_[robot.number];
  const Hold hold{watch.farthest_from(view.ball.position), view.time - watch.since};
  const WithBall what = choose_with_ball(view, robot, *choice_, hold, situation.their_time, parameters);
  if (what == WithBall::Release) {
    if (view.time - released_at_ > go_round_for) released_at_ = view.time;
    return order_with_ball(view, robot, what, *choice_, hold, view.time - released_at_, parameters);
  }
  return order_with_ball(view, robot, what, *choice_, hold, 0, parameters);
}

skills::Order Winner::fetch(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                            const KickRules& rules, const Parameters& parameters) {
  const kit::Ball& ball = view.ball;
  const Vector2d to_ball = ball.position - robot.position;
  if (skills::is_at_wall(view)) return skills::free_from_wall(view, robot);
  if (const HoldWatch& watch = holds_[robot.number]; watch.places > 0) {
    const double pushed =
        (ball.position - watch.farthest_from(ball.position)).norm() + letting_go_takes * ball.velocity.norm();
    if (pushed > parameters.dribble_distance) return skills::let_go(view, robot);
  }
  // A ball that comes is let come until it is there; one that leaves, or is beside the robot, is gone to.
  const double speed_of_ball = ball.velocity.norm();
  const bool comes = -ball.velocity.dot(to_ball) > 0.7 * speed_of_ball * to_ball.norm();
  const bool theirs = std::any_of(view.opponents.begin(), view.opponents.end(), [&](const kit::Robot& other) {
    return kit::holds_ball(other, ball, view.field().ball_radius);
  });
  if (!theirs && speed_of_ball >= slow_ball && (comes || to_ball.norm() > 0.25)) {
    return let_come(view, situation, robot, rules, parameters);
  }
  redirect_.reset();
  const Kick& kick = *choice_;
  const bool just_released = view.time - released_at_ < go_round_for;
  const double first = situation.meetings[robot.number].time;
  if (just_released || goes_round(view, robot, kick.direction, situation.their_time - first, parameters)) {
    const double speed = kick.kind == Kick::Kind::Dribble ? 0 : kick.speed;
    return skills::approach_and_kick(view, robot, kick.direction, speed, kick.angle, kick.tolerance);
  }
  return skills::capture(view, robot, situation.model);
}

// A ball that comes: on with one touch when that is a shot, else it is stopped.
skills::Order Winner::let_come(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                               const KickRules& rules, const Parameters& parameters) {
  const std::optional<skills::Meeting> meeting = skills::arrival(view, robot, situation.model);
  if (!meeting) redirect_.reset();
  if (meeting && view.time - redirect_chosen_at_ >= rethink) {
    redirect_chosen_at_ = view.time;
    std::optional<Kick> shot;
    if (rules.shot_allowed) shot = choose_one_touch(view, robot, *meeting, parameters, redirect_);
    redirect_ = shot ? shot : pass_on(view, situation, robot, *meeting, parameters);
  }
  if (meeting && redirect_) {
    return skills::redirect(view, robot, *meeting, redirect_->direction, redirect_->speed,
                            redirect_->tolerance);
  }
  return skills::receive(view, robot, situation.model);
}

// Nobody has time to stop the ball and align: pass or clear it with one touch, if its way allows.
std::optional<Kick> Winner::pass_on(const kit::View& view, const Situation& situation,
                                    const kit::Robot& robot, const skills::Meeting& meeting,
                                    const Parameters& parameters) const {
  if (choice_->kind == Kick::Kind::Dribble || choice_->kind == Kick::Kind::Shot) return {};
  Kick kick = *choice_;
  kick.direction = world::angle_of(kick.target - meeting.position);
  if (skills::redirect_angle(view.ball.velocity, kick.direction) > skills::steepest_redirect) return {};
  const double turn = skills::redirect_angle(view.ball.velocity, kick.direction);
  const double aligned_at = meeting.time + time_to_align(view, robot, turn, parameters);
  if (situation.their_time > aligned_at) return {};
  return kick;
}

std::optional<Kick> choose_one_touch(const kit::View& view, const kit::Robot& robot,
                                     const skills::Meeting& meeting, const Parameters& parameters,
                                     const std::optional<Kick>& before) {
  std::optional<double> aimed;
  if (before) aimed = before->direction;
  const skills::Opening opening =
      skills::opening_to_goal(view, meeting.position, parameters.shot_speed, robot.number, aimed);
  const double distance = (view.their_goal() - meeting.position).norm();
  const double chance = goal_chance(opening.width, distance);
  if (chance < parameters.shot_threshold + (before ? -0.05 : 0.05)) return {};
  const double steepest = skills::steepest_redirect + (before ? 0.1 : 0.0);
  if (skills::redirect_angle(view.ball.velocity, opening.direction) > steepest) return {};
  Kick kick;
  kick.kind = Kick::Kind::Shot;
  kick.target = opening.target;
  kick.direction = opening.direction;
  kick.speed = parameters.shot_speed;
  kick.tolerance = skills::kick_tolerance(opening.width);
  kick.value = chance;
  return kick;
}

}  // namespace reference
