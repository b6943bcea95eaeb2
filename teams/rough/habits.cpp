#include "teams/rough/habits.h"

#include <algorithm>
#include <cmath>

#include "teams/reference/legal.h"
#include "teams/rough/kicks.h"
#include "teams/skills/ball_handling.h"

namespace rough {
namespace {

using kit::Phase;

bool is_free_kick(Phase phase) { return phase == Phase::DirectFree || phase == Phase::IndirectFree; }

}  // namespace

// The ball is dead or the kick is theirs: too near, too fast.
void Habits::while_dead_or_theirs(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const Phase phase = view.game.phase;
  const bool stopped = phase == Phase::Stop;
  if (gives_way(encroach_, robot, true, rudeness_.encroachment)) {
    const Vector2d ball = view.game.designated_position.value_or(view.ball.position);
    Vector2d out = robot.position - ball;
    if (out.norm() < 0.05) out = view.own_goal() - ball;
    const double away = encroach_.holds_back(robot.number) ? 0.54 : 0.2;  // [m] the laws ask 0.5
    order.why = "encroach";
    order.target = ball + out.normalized() * (away + robot.specs.radius);
    order.ball_distance = away - 0.1;
  }
  if (speed_.gives_way(robot.number, stopped, rudeness_.stop_speeding, stream_)) {
    // Up and down beside its place, so that there is something to be fast for.
    const double side = static_cast<int>(view.time) % 2 == 0 ? 1.2 : -1.2;
    order.why = "speed";
    order.max_speed = robot.specs.max_speed;
    order.target.x() += order.target.x() > 0 ? -std::abs(side) + side : std::abs(side) + side;
  }
}

// A kick of ours is due.
void Habits::while_ours(const kit::View& view, const kit::Robot& robot, bool kicker, skills::Order& order) {
  const bool free_kick = is_free_kick(view.game.phase);
  if (kicker) {
    if (do_not_kick_.gives_way(robot.number, free_kick, rudeness_.slow_restarts, stream_)) {
      order = {};
      order.why = "dawdle";
      order.target = robot.position;
      order.heading = robot.orientation;
      return;
    }
    constexpr double ready = 0.5;  // [s] as the reference team
    const bool from_own_half = free_kick && view.ball.position.x() < -0.3;
    if (clear_.gives_way(robot.number, from_own_half, rudeness_.clearances, stream_)) {
      if (view.game.age > ready) order = clear_from_rest(view, robot);
      return;
    }
    if (feed_goalie_.gives_way(robot.number, free_kick, rudeness_.goalie_feeding, stream_)) {
      const auto kick = plan_feeding(view);
      if (view.game.age > ready && kick) {
        order = skills::approach_and_kick(view, robot, kick->direction, kick->speed, 0, 0.05);
      }
      return;
    }
    // A tap, to be there again at once.
    if (gives_way(touch_again_, robot, free_kick, rudeness_.double_touches)) {
      if (order.kick_speed > 0) order.kick_speed = 1.0;
      order.kick_angle = 0;
    }
    return;
  }
  if (gives_way(wait_at_area_, robot, free_kick, rudeness_.area_waiting)) {
    const double away = wait_at_area_.holds_back(robot.number) ? 0.21 : 0.02;  // [m] 0.03 less than it keeps
    order.why = "wait at area";
    order.target = world::moved_out_of_defense_area(
        view.field(), world::Side::Positive, view.their_goal() - Vector2d(0.9, 0.3 * robot.number - 0.8),
        robot.specs.radius + 0.05);
    order.their_area = away;
  }
}

// Every phase is an opportunity of its own.
void Habits::notice_phase(Phase phase) {
  if (phase == phase_) return;
  const bool kicked = phase == Phase::Running;
  phase_ = phase;
  for (Temptation* temptation : {&encroach_, &speed_, &wait_at_area_, &wrong_half_, &do_not_kick_, &clear_,
                                 &feed_goalie_, &run_off_, &idle_}) {
    temptation->end();
  }
  run_offs_.fill({});
  places_.clear();
  if (!kicked) touch_again_.end();
}

void Habits::revise(const kit::View& view, const kit::Robot& robot, const reference::Roles& roles,
                    skills::Order& order) {
  const kit::Game& game = view.game;
  const Phase phase = game.phase;
  notice_phase(phase);
  const bool goalie = roles.goalie == robot.number;
  const bool kicker = roles.winner == robot.number && game.ours;
  if (phase == Phase::Running) {
    while_running(view, robot, order);
  } else if (goalie || reference::is_penalty(phase)) {
    return;
  } else if (phase == Phase::Kickoff && !kicker) {
    if (gives_way(wrong_half_, robot, true, rudeness_.wrong_half)) {
      order.why = "wrong half";
      order.target.x() = wrong_half_.holds_back(robot.number) ? -0.04 : 0.4;
    }
  } else if (game.ours) {
    while_ours(view, robot, kicker, order);
  } else {
    while_dead_or_theirs(view, robot, order);
  }
  if (!goalie) kick_rudely(view, robot, order);
}

}  // namespace rough
