#include "teams/reference/with_ball.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/turn_dribble.h"

namespace reference {
namespace {

constexpr double aligned = 12 * M_PI / 180;  // [rad]
constexpr double settle = 0.05;              // [s] three frames
constexpr double kick_takes = 0.15;          // [s] ours: with 0.85 m no dribble ends beyond 1 m
constexpr double longest_hold = 4.0;         // [s]
// [s] A robot with an opponent at the ball keeps it this long at most (ours: pushed robots lose the ball).
constexpr double longest_pressed = 1.0;
constexpr double pressing = 0.25;  // [m] an opponent's centre to the ball

bool is_pressed(const kit::View& view) {
  return std::any_of(view.opponents.begin(), view.opponents.end(), [&](const kit::Robot& other) {
    return (other.position - view.ball.position).norm() < pressing;
  });
}

// Kicks ahead from here would go towards our own goal.
bool looks_home(const kit::View& view, const kit::Robot& robot) {
  return world::direction(robot.orientation).x() < -0.2 && view.ball.position.x() < 0;
}

// Looks into the opening to their goal, from not too far.
bool shoots_ahead(const kit::View& view, const kit::Robot& robot, const Parameters& parameters) {
  const Vector2d ball = view.ball.position;
  if ((view.their_goal() - ball).norm() > 4) return false;  // [m] ours
  const skills::Opening opening =
      skills::opening_to_goal(view, ball, parameters.shot_speed, robot.number, robot.orientation);
  return std::abs(world::wrap_angle(opening.direction - robot.orientation)) < 0.5 * opening.width;
}

}  // namespace

const char* name(WithBall what) {
  switch (what) {
    case WithBall::Settle:
      return "settle";
    case WithBall::Align:
      return "align";
    case WithBall::Turn:
      return "turn";
    case WithBall::Release:
      return "release";
    case WithBall::Carry:
      return "carry";
    case WithBall::KickAhead:
      return "kick ahead";
  }
  return "unknown";
}

double time_to_align(const kit::View& view, const kit::Robot& robot, double angle,
                     const Parameters& parameters) {
  return parameters.turn_dribble ? skills::turn_time(robot, angle, parameters.turn_rate)
                                 : skills::orbit_time(robot, angle, view.field().ball_radius);
}

bool goes_round(const kit::View& view, const kit::Robot& robot, double direction, double ahead_of_them,
                const Parameters& parameters) {
  const double towards = world::angle_of(view.ball.position - robot.position);
  const double off = std::abs(world::wrap_angle(towards - direction));
  if (off < 0.35) return true;  // [rad] nearly the same way
  const double round = skills::orbit_time(robot, off, view.field().ball_radius);
  const double turn =
      settle + (parameters.turn_dribble ? skills::turn_time(robot, off, parameters.turn_rate) : round);
  const bool safe = ahead_of_them > round;
  // Taken the shortest way the ball could then only be kicked home.
  const bool hopeless = !parameters.turn_dribble && world::direction(towards).x() < -0.2;
  return round <= turn && (safe || hopeless);
}

WithBall choose_with_ball(const kit::View& view, const kit::Robot& robot, const Kick& kick, const Hold& hold,
                          double their_time, const Parameters& parameters) {
  if (hold.time < settle) return WithBall::Settle;
  // Until the ball has left it goes on with the robot: the radio and the kicker need a moment.
  const double carried = (view.ball.position - hold.start).norm() + kick_takes * view.ball.velocity.norm();
  const double error = std::abs(world::wrap_angle(kick.direction - robot.orientation));
  const bool far = carried > parameters.dribble_distance;
  const bool too_long = hold.time > longest_hold;
  // Sheltered by the turning robot the ball may be kept under pressure for a while; let go of it must be safe
  // until the robot has gone round.
  const double align = time_to_align(view, robot, error, parameters);
  const bool hopeless =
      error > aligned && (parameters.turn_dribble ? is_pressed(view) && hold.time + align > longest_pressed
                                                  : their_time < align);
  if (far || too_long || hopeless) {
    if (!looks_home(view, robot)) return WithBall::KickAhead;
    if (far || too_long || !parameters.turn_dribble) return WithBall::Release;
    return WithBall::Turn;
  }
  if (error < aligned) return kick.kind == Kick::Kind::Dribble ? WithBall::Carry : WithBall::Align;
  return parameters.turn_dribble ? WithBall::Turn : WithBall::Release;
}

skills::Order order_with_ball(const kit::View& view, const kit::Robot& robot, WithBall what, const Kick& kick,
                              const Hold& hold, double released, const Parameters& parameters) {
  const bool kicks = kick.kind != Kick::Kind::Dribble;
  const double kick_speed = kicks ? kick.speed : 0;
  switch (what) {
    case WithBall::Settle: {
      skills::Order order = skills::carry(robot, robot.orientation, 0.1);
      order.robot_margin = 0;
      if (kicks && std::abs(world::wrap_angle(kick.direction - robot.orientation)) < kick.tolerance) {
        order.kick_speed = kick.speed;
        order.kick_angle = kick.angle;
      }
      order.why = name(what);
      return order;
    }
    case WithBall::Release:
      return skills::release(robot, released);
    case WithBall::Carry: {
      skills::Order order = skills::carry(robot, kick.direction, std::min(1.0, 0.4 + hold.time));
      order.why = name(what);
      return order;
    }
    case WithBall::KickAhead:
      return skills::kick_ahead(view, robot,
                                shoots_ahead(view, robot, parameters) ? parameters.shot_speed : 2.5);
    case WithBall::Align:
    case WithBall::Turn:
      break;
  }
  skills::Order order = skills::turn_and_kick(view, robot, kick.direction, kick_speed, kick.angle,
                                              kick.tolerance, parameters.turn_rate);
  order.why = name(what);
  return order;
}

}  // namespace reference
