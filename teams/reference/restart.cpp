#include "teams/reference/restart.h"

#include <algorithm>
#include <cmath>

#include "teams/reference/set_play.h"
#include "teams/skills/ball_handling.h"

namespace reference {
namespace {

// Out of a circle, towards where the point is anyway; towards our own goal from its centre.
Vector2d moved_out(const Vector2d& point, const Vector2d& center, double radius, const Vector2d& own_goal) {
  Vector2d out = point - center;
  if (out.norm() >= radius) return point;
  if (out.norm() < 0.05) out = own_goal - center;
  return center + out.normalized() * radius;
}

}  // namespace

void keep_away(const kit::View& view, const kit::Robot& robot, const Parameters& parameters, bool slow,
               skills::Order& order) {
  const double radius = robot.specs.radius + view.field().ball_radius + parameters.stop_distance + 0.02;
  order.velocity.reset();
  order.kick_speed = 0;
  order.dribble = false;
  order.ball_distance = parameters.stop_distance;
  order.their_area = std::max(order.their_area, 0.25);
  order.robot_margin = std::max(order.robot_margin, 0.03);
  if (slow) order.max_speed = std::min(order.max_speed, parameters.stop_speed);
  order.target = moved_out(order.target, view.ball.position, radius, view.own_goal());
  if (view.game.designated_position) {
    order.target = moved_out(order.target, *view.game.designated_position, radius, view.own_goal());
  }
}

void stay_in_own_half(const kit::Robot& robot, skills::Order& order) {
  order.target.x() = std::min(order.target.x(), -robot.specs.radius - 0.08);
}

void stay_behind_penalty_line(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const double mark = view.field().half_length() - view.field().penalty_mark_distance;
  const double room = 0.4 + robot.specs.radius + 0.1;
  if (view.game.ours) {
    order.target.x() = std::min(order.target.x(), mark - room);
  } else {
    order.target.x() = std::max(order.target.x(), -mark + room);
  }
}

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
  order.target = view.own_goal() + Vector2d(0.02, 0);
  order.heading = world::angle_of(view.ball.position - robot.position);
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
