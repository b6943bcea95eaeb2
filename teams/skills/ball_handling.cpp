#include "teams/skills/ball_handling.h"

#include <algorithm>
#include <cmath>

#include "teams/kit/ball_course.h"
#include "teams/skills/intercept.h"
#include "teams/skills/motion.h"

namespace skills {
namespace {

constexpr double orbit_air = 0.03;  // [m] between hull and ball on the way round it

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

double orbit_radius(const kit::Robot& robot, double ball_radius) {
  return robot.specs.radius + ball_radius + orbit_air;
}

double orbit_speed(const kit::Robot& robot, double radius) {
  return std::sqrt(0.9 * driving_limits(robot.specs).acceleration * radius);
}

// How far round the ball the robot has to go [rad], with sign: counter-clockwise positive.
double way_round(const kit::Ball& ball, const kit::Robot& robot, double direction) {
  return world::wrap_angle(direction + M_PI - world::angle_of(robot.position - ball.position));
}

// Straight through the ball: the ball's own velocity plus a push along the aim, and a correction sideways.
Vector2d push(const kit::Ball& ball, const kit::Robot& robot, const Vector2d& aim, double speed) {
  const Vector2d to_ball = ball.position - robot.position;
  const double sideways = to_ball.dot(left_of(aim));
  return ball.velocity + aim * speed + left_of(aim) * std::clamp(4.0 * sideways, -0.6, 0.6);
}

}  // namespace

double reach_of(const kit::Robot& robot, double ball_radius) {
  return robot.specs.center_to_dribbler + ball_radius;
}

Vector2d behind_ball(const Vector2d& ball, const Vector2d& direction, const kit::Robot& robot,
                     double ball_radius, double gap) {
  return ball - direction * (reach_of(robot, ball_radius) + gap);
}

Vector2d orbit_velocity(const kit::Ball& ball, const kit::Robot& robot, double direction,
                        double ball_radius) {
  Vector2d out = robot.position - ball.position;
  const double distance = out.norm();
  out = distance > 1e-6 ? Vector2d(out / distance) : Vector2d(-world::direction(direction));
  const double left = way_round(ball, robot, direction);
  const double orbit = orbit_radius(robot, ball_radius);
  const double contact = reach_of(robot, ball_radius);
  const double wanted = contact + (orbit - contact) * std::min(std::abs(left) / 0.3, 1.0);
  // Not yet out on the circle: first away from the ball, or the hull would sweep it along.
  const double clear = std::clamp((distance - contact) / orbit_air, 0.15, 1.0);
  const double brake = 0.5 * driving_limits(robot.specs).brake;
  const double round =
      clear * std::min(orbit_speed(robot, orbit), std::sqrt(2 * brake * std::abs(left) * orbit));
  return ball.velocity + left_of(out) * (left < 0 ? -round : round) +
         out * std::clamp(8.0 * (wanted - distance), -0.6, 0.6);
}

double orbit_time(const kit::Robot& robot, double angle, double ball_radius) {
  const double radius = orbit_radius(robot, ball_radius);
  Limits limits = driving_limits(robot.specs);
  limits.speed = std::min(limits.speed, orbit_speed(robot, radius));
  const double back_off = 0.2;  // [s] out to the circle and in again
  return back_off + time_to_rest(std::abs(angle) * radius, 0, limits);
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

  // Two cameras may put robot and ball 40 mm nearer to each other than they are: on, until it touches.
  const double gap = ahead - reach_of(robot, ball_radius);
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
  if ((view.ball.position - robot.position).norm() < 0.3 && view.ball.velocity.norm() < 1.0 && !ball.flies) {
    order.why = "orbit";
    order.velocity = orbit_velocity(view.ball, robot, direction, ball_radius);
    return order;
  }
  // Not behind it yet: a place behind, round the ball.
  order.target = behind_ball(ball.position, aim, robot, ball_radius, 0.06);
  order.ball_distance = 0.025;
  return order;
}

Order capture(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model) {
  const double contact = reach_of(robot, view.field().ball_radius);
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

Order release(const kit::Robot& robot, double since) {
  Order order;
  order.why = "release";
  order.heading = robot.orientation;
  order.robot_margin = 0;
  order.velocity = Vector2d::Zero();
  if (since < 0.05) {  // [s] three ticks: the simulator's bar changes the spin in one
    order.dribble = true;
    order.dribble_share = 0.03;
  } else {
    order.velocity = -0.5 * world::direction(robot.orientation);
  }
  return order;
}

Order let_go(const kit::View& view, const kit::Robot& robot) {
  Order order;
  order.why = "let go";
  const Vector2d away = robot.position - view.ball.position;
  order.heading = world::angle_of(-away);
  order.robot_margin = 0;
  order.velocity = 0.8 * away.normalized();
  return order;
}

Order kick_ahead(const kit::View& view, const kit::Robot& robot, double speed) {
  Order order;
  order.why = "kick ahead";
  order.heading = robot.orientation;
  order.robot_margin = 0;
  const Vector2d ahead = world::direction(robot.orientation);
  // On with the speed it has: braking, the ball would roll out of the kicker's reach.
  order.velocity = std::max(0.3, robot.velocity.dot(ahead) + 0.1) * ahead;
  order.dribble = true;
  order.kick_speed = speed;
  // A chip that flies into their goal does not count (laws of 2015, Law 12, decision 7).
  const Vector2d to_goal = view.their_goal() - robot.position;
  const bool at_goal = to_goal.norm() < 4 && to_goal.dot(ahead) > 0 &&
                       std::abs(to_goal.dot(left_of(ahead))) < view.field().goal_width;
  for (const kit::Robot& other : view.opponents) {
    const Vector2d to = other.position - robot.position;
    const double forward = to.dot(ahead);
    if (forward > 0 && forward < 0.5 && std::abs(to.dot(left_of(ahead))) < 0.1 && !at_goal) {
      order.kick_speed = 3.5;  // [m/s] at 45 degrees: 1.2 m to the first landing
      order.kick_angle = M_PI / 4;
    }
  }
  return order;
}

Order carry(const kit::Robot& robot, double heading, double speed) {
  Order order;
  order.why = "dribble";
  order.heading = heading;
  order.max_turn = 2.0;
  order.dribble = true;
  order.robot_margin = 0.05;
  order.velocity = world::direction(robot.orientation) * speed;
  return order;
}

bool is_at_wall(const kit::View& view) {
  // A robot behind the ball needs its diameter and a little between ball and wall.
  const double room = view.field().boundary_width - 0.25;
  return world::distance_outside_lines(view.field(), view.ball.position) > room;
}

Order free_from_wall(const kit::View& view, const kit::Robot& robot) {
  const world::Field& field = view.field();
  const kit::Ball& ball = view.ball;
  // Away from the nearer wall, or from both in a corner.
  const double edge = field.boundary_width - 0.25;
  Vector2d inwards = Vector2d::Zero();
  if (std::abs(ball.position.x()) > field.half_length() + edge) inwards.x() = ball.position.x() > 0 ? -1 : 1;
  if (std::abs(ball.position.y()) > field.half_width() + edge) inwards.y() = ball.position.y() > 0 ? -1 : 1;
  if (inwards.norm() < 0.5) inwards = -ball.position;
  inwards.normalize();
  Order order;
  order.why = "free from wall";
  order.heading = world::angle_of(-inwards);
  order.robot_margin = 0;
  order.dribble = true;
  const double contact = reach_of(robot, field.ball_radius);
  if (kit::holds_ball(robot, ball, field.ball_radius)) {
    // The bar holds a ball that is pulled with up to 5 m/s^2.
    const double speed = -robot.velocity.dot(-inwards);
    order.velocity = inwards * std::min(speed + 0.04, 0.8);
    return order;
  }
  const Vector2d to_ball = ball.position - robot.position;
  const double beside = to_ball.dot(left_of(inwards));
  const double gap = -to_ball.dot(inwards) - contact;
  if (gap > -0.05 && std::abs(beside) < 0.03 + 0.1 * std::max(gap, 0.0)) {
    order.velocity = ball.velocity - inwards * std::clamp(0.2 + 2.0 * gap, 0.2, 1.0) -
                     left_of(inwards) * std::clamp(-4.0 * beside, -0.4, 0.4);
    return order;
  }
  order.target = ball.position + inwards * (contact + 0.06);
  order.ball_distance = 0.02;
  return order;
}

}  // namespace skills
