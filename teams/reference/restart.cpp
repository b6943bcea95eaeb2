#include "teams/reference/restart.h"

#include <algorithm>
#include <cmath>

#include "teams/reference/set_play.h"
#include "teams/skills/ball_handling.h"

namespace reference {

skills::Order block_the_ball(const kit::View& view, const kit::Robot& robot, const Parameters& parameters) {
  skills::Order order;
  order.why = "block";
  const Vector2d ball = view.game.designated_position.value_or(view.ball.position);
  const double radius = robot.specs.radius + view.field().ball_radius + parameters.stop_distance + 0.03;
  Vector2d to_goal = view.own_goal() - ball;
  if (to_goal.norm() < 0.1) to_goal = Vector2d(-1, 0);
  order.target = ball + to_goal.normalized() * radius;
  order.heading = world::angle_of(ball - robot.position);
  return order;
}

skills::Order wait_behind_ball(const kit::View& view, const kit::Robot& robot) {
  skills::Order order;
  order.why = "wait to kick";
  const Vector2d aim = (view.their_goal() - view.ball.position).normalized();
  order.target = skills::behind_ball(view.ball.position, aim, robot, view.field().ball_radius, 0.15);
  order.heading = world::angle_of(aim);
  order.ball_distance = 0.08;
  return order;
}

skills::Order take_penalty(const kit::View& view, const kit::Robot& robot, const Parameters& parameters) {
  skills::Order order =
      skills::approach_and_kick(view, robot, penalty_direction(view), parameters.shot_speed, 0, 0.04);
  order.why = "penalty";
  return order;
}

skills::Order face_penalty(const kit::View& view, const kit::Robot& robot) {
  skills::Order order;
  order.why = "face penalty";
  order.enter_own_area = true;
  const Vector2d goal = view.own_goal();
  order.target = goal + Vector2d(0.02, 0);
  order.heading = world::angle_of(view.ball.position - robot.position);
  // Their kicker: the nearest of them behind the ball.
  const kit::Robot* kicker = nullptr;
  for (const kit::Robot& other : view.opponents) {
    const double gap = (other.position - view.ball.position).norm();
    if (gap < 0.5 && (kicker == nullptr || gap < (kicker->position - view.ball.position).norm())) {
      kicker = &other;
    }
  }
  if (kicker == nullptr) return order;
  const Vector2d looks = world::direction(kicker->orientation);
  if (looks.x() > -0.5) return order;
  // Half of the way there (ours): all of it would leave the other side to whoever looks away.
  const double crossing =
      view.ball.position.y() + looks.y() * (goal.x() - view.ball.position.x()) / looks.x();
  const double most = view.field().goal_width / 2 - robot.specs.radius;
  order.target.y() = std::clamp(0.5 * crossing, -most, most);
  return order;
}

skills::Order leave_ball(const kit::View& view, const kit::Robot& robot) {
  skills::Order order;
  order.why = "leave ball";
  Vector2d away = robot.position - view.ball.position;
  if (away.norm() < 1e-3) away = Vector2d(-1, 0);
  order.target = robot.position;
  if (away.norm() < 0.6) order.target = view.ball.position + away.normalized() * 0.7;
  order.heading = world::angle_of(view.ball.position - robot.position);
  order.ball_distance = 0.25;
  return order;
}

}  // namespace reference
