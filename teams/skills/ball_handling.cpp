#include "teams/skills/ball_handling.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/intercept.h"
#include "teams/skills/motion.h"
#include "teams/skills/steer.h"

namespace skills {
namespace {

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

// Straight through the ball: the ball's own velocity plus a push along the aim, and a correction sideways.
Vector2d push(const kit::Ball& ball, const kit::Robot& robot, const Vector2d& aim, double speed) {
  const Vector2d to_ball = ball.position - robot.position;
  const double sideways = to_ball.dot(left_of(aim));
  return ball.velocity + aim * speed + left_of(aim) * std::clamp(4.0 * sideways, -0.6, 0.6);
}

}  // namespace

Vector2d behind_ball(const Vector2d& ball, const Vector2d& direction, const kit::Robot& robot,
                     double ball_radius, double gap) {
  return ball - direction * (robot.specs.center_to_dribbler + ball_radius + gap);
}

Order approach_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                        double kick_angle, double tolerance) {
  const double ball_radius = view.field().ball_radius;
  const Vector2d aim = world::direction(direction);
  Order order;
  order.why = "approach";
  order.heading = direction;
  order.robot_margin = 0.0;

  // Aim at where the ball will be when we are there.
  const double time = std::min(
      travel_time(view.ball.position - robot.position, robot.velocity, driving_limits(robot.specs)), 0.6);
  const kit::Ball ball = kit::predicted(view.ball, kit::BallModel(view.geometry), 0.7 * time);
  const Vector2d to_ball = ball.position - robot.position;
  const double ahead = to_ball.dot(aim);
  const double sideways = to_ball.dot(left_of(aim));
  const double heading_error = std::abs(world::wrap_angle(robot.orientation - direction));
  const double contact = robot.specs.center_to_dribbler + ball_radius;

  // Two cameras may put robot and ball 40 mm nearer to each other than they are: on, until it touches.
  const double gap = ahead - contact;
  const bool in_the_lane = gap > -0.05 && std::abs(sideways) < 0.02 + 0.15 * std::max(gap, 0.0);
  if (in_the_lane && heading_error < 0.3 && ahead < 0.6) {
    order.velocity = push(ball, robot, aim, std::clamp(0.25 + 4.0 * gap, 0.3, 1.5));
    order.dribble = true;
    if (heading_error < tolerance && std::abs(sideways) < 0.02) {
      order.kick_speed = kick_speed;
      order.kick_angle = kick_angle;
    }
    return order;
  }
  // Not behind it yet: a place behind, round the ball.
  order.target = behind_ball(ball.position, aim, robot, ball_radius, 0.06);
  order.ball_distance = 0.025;
  return order;
}

Order capture(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model) {
  const double ball_radius = view.field().ball_radius;
  const double contact = robot.specs.center_to_dribbler + ball_radius;
  const Limits limits = driving_limits(robot.specs);
  const Meeting meeting = meet(view, robot, limits, model, contact, 0.05);
  const Vector2d to_ball = view.ball.position - robot.position;
  Order order;
  order.why = "capture";
  order.dribble = true;
  order.robot_margin = 0.0;
  order.heading = world::angle_of(to_ball);
  const double distance = to_ball.norm();
  if (distance < contact + 0.25 && view.ball.velocity.norm() < 1.5) {
    const Vector2d towards = to_ball / std::max(distance, 1e-6);
    const double gap = distance - contact;
    order.velocity = view.ball.velocity + towards * std::clamp(0.3 + 3.0 * gap, 0.3, 1.2);
    return order;
  }
  // Come to stand just short of it, looking at it.
  Vector2d from = robot.position - meeting.position;
  if (from.norm() < 1e-6) from = -to_ball;
  order.target = meeting.position + from.normalized() * std::max(contact - 0.03, 0.0);
  return order;
}

Order turn_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                    double kick_angle, double tolerance) {
  Order order;
  order.why = "turn";
  order.dribble = true;
  order.robot_margin = 0.0;
  order.heading = direction;
  order.max_turn =
      4.0;  // [rad/s] faster loses the ball: m w^2 rho against friction (reference "football", 2.10)
  const double error = world::wrap_angle(direction - robot.orientation);
  // Turn about the ball rather than about ourselves: the centre swings round it, pressing gently forwards.
  const double rate = turning(robot, direction, order.max_turn);
  const double arm = robot.specs.center_to_dribbler + view.field().ball_radius;
  const Vector2d heading = world::direction(robot.orientation);
  order.velocity = heading * 0.15 - left_of(heading) * (rate * arm) * 0.7;
  if (std::abs(error) < tolerance && std::abs(robot.angular_velocity) < 3.0) {
    order.kick_speed = kick_speed;
    order.kick_angle = kick_angle;
  }
  return order;
}

Order receive(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model) {
  const double ball_radius = view.field().ball_radius;
  const double contact = robot.specs.center_to_dribbler + ball_radius;
  const Limits limits = driving_limits(robot.specs);
  const Meeting meeting = meet(view, robot, limits, model, contact, 0.1);
  const double speed = view.ball.velocity.norm();
  if (speed < 0.4 || !meeting.before_it_stops) {
    Order order = capture(view, robot, model);
    order.why = "fetch";
    return order;
  }
  const Vector2d along = view.ball.velocity / speed;
  Order order;
  order.why = "receive";
  order.dribble = true;
  order.heading = world::angle_of(-along);
  order.robot_margin = 0.0;
  order.target = meeting.position + along * contact;
  // Already on its line: wait there rather than running away from the ball along it.
  const Vector2d from_ball = robot.position - view.ball.position;
  const double ahead = from_ball.dot(along);
  const double beside = from_ball.dot(left_of(along));
  if (ahead > 0 && std::abs(beside) < 0.25 && ahead < model.stopping_distance(speed, view.ball.rolls_below)) {
    order.target = view.ball.position + along * std::max(ahead, contact);
  }
  return order;
}

}  // namespace skills
