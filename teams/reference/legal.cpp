#include "teams/reference/legal.h"

#include <algorithm>
#include <cmath>

namespace reference {
namespace {

using kit::Phase;

// [m] Hull to their defense area while a kick of ours is due; the laws ask 0.2 (Law 9),
// noise and cameras 0.05.
constexpr double attacker_distance = 0.25;

void keep_away(const kit::View& view, const kit::Robot& robot, const Parameters& parameters, bool goalie,
               skills::Order& order) {
  order.velocity.reset();
  order.kick_speed = 0;
  order.dribble = false;
  order.ball_distance = parameters.stop_distance;
  order.their_area = std::max(order.their_area, attacker_distance);
  order.robot_margin = std::max(order.robot_margin, 0.03);
  const double distance = parameters.stop_distance + 0.02;
  order.target = clear_of_ball(view, robot, order.target, view.ball.position, distance, goalie);
  if (view.game.designated_position) {
    order.target = clear_of_ball(view, robot, order.target, *view.game.designated_position, distance, goalie);
  }
}

void stay_in_own_half(const kit::Robot& robot, skills::Order& order) {
  order.target.x() = std::min(order.target.x(), -robot.specs.radius - 0.08);
}

// Everyone but kicker and goalie 0.4 m behind the mark (laws of 2015, Law 14).
void stay_behind_penalty_line(const kit::View& view, const kit::Robot& robot, skills::Order& order) {
  const double mark = view.field().half_length() - view.field().penalty_mark_distance;
  const double room = 0.4 + robot.specs.radius + 0.1;
  if (view.game.ours) {
    order.target.x() = std::min(order.target.x(), mark - room);
  } else {
    order.target.x() = std::max(order.target.x(), -mark + room);
  }
}

}  // namespace

bool is_dead(Phase phase) { return phase == Phase::Stop || phase == Phase::Timeout || phase == Phase::Halt; }

bool is_kickoff(Phase phase) { return phase == Phase::PrepareKickoff || phase == Phase::Kickoff; }

bool is_penalty(Phase phase) { return phase == Phase::PreparePenalty || phase == Phase::Penalty; }

Vector2d clear_of_ball(const kit::View& view, const kit::Robot& robot, const Vector2d& point,
                       const Vector2d& ball, double distance, bool goalie) {
  const world::Field& field = view.field();
  const double radius = distance + robot.specs.radius + field.ball_radius;
  constexpr double room = 0.2;  // [m] beyond the lines; from 0.25 on is the referee's (Law 1)
  const double off_area = robot.specs.radius + 0.03;
  const auto is_free = [&](const Vector2d& place) {
    return world::distance_outside_lines(field, place) < room &&
           (goalie || world::distance_to_defense_area(field, world::Side::Negative, place) >= off_area) &&
           world::distance_to_defense_area(field, world::Side::Positive, place) >= off_area;
  };
  Vector2d out = point - ball;
  if (out.norm() >= radius && is_free(point)) return point;
  if (out.norm() < 0.05) out = view.own_goal() - ball;
  constexpr double step = 0.1;      // [rad]
  constexpr double farther = 0.25;  // [m] where no direction is free: the ball lies in the goal's corner
  double far = std::max(radius, out.norm());
  out.normalize();
  for (int ring = 0; ring < 8; ++ring, far += farther) {
    for (int k = 0; k * step < M_PI; ++k) {
      for (const int side : {1, -1}) {
        const Vector2d place = ball + far * world::rotated(out, side * k * step);
        if (is_free(place)) return place;
      }
    }
  }
  return ball + far * out;
}

void make_legal(const kit::View& view, const kit::Robot& robot, const Roles& roles,
                const Parameters& parameters, skills::Order& order) {
  const kit::Game& game = view.game;
  if (game.phase == Phase::Running) return;
  const bool kicker = roles.winner == robot.number && game.ours;
  const bool goalie = roles.goalie == robot.number;
  if (is_dead(game.phase)) {
    // The ball on the centre mark: most likely a kickoff, so be at home already.
    const Vector2d place = game.designated_position.value_or(view.ball.position);
    if (place.norm() < 0.1 && !goalie) stay_in_own_half(robot, order);
    order.max_speed = std::min(order.max_speed, parameters.stop_speed);
    keep_away(view, robot, parameters, goalie, order);
    return;
  }
  if (is_kickoff(game.phase) && !(kicker && game.phase == Phase::Kickoff)) stay_in_own_half(robot, order);
  if (is_penalty(game.phase) && !kicker && !goalie) stay_behind_penalty_line(view, robot, order);
  if (kicker) {
    // The penalty mark lies on the edge of their area; the kicker may go there (Law 9 speaks of team-mates).
    order.their_area = is_penalty(game.phase) ? -0.3 : attacker_distance;
    return;
  }
  if (game.ours) {
    order.ball_distance = std::max(order.ball_distance, 0.3);
    order.their_area = attacker_distance;
    order.kick_speed = 0;
  } else if (!(goalie && is_penalty(game.phase))) {
    keep_away(view, robot, parameters, goalie, order);
  }
}

}  // namespace reference
