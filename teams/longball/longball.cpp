#include "teams/longball/longball.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/turn_dribble.h"

namespace longball {
namespace {

using kit::Phase;

constexpr double tolerance = 0.08;    // [rad] of a long kick's heading: 0.3 m at 4 m
constexpr double fastest_chip = 5.5;  // [m/s]
constexpr double arrival = 1.5;       // [m/s] of a flat long ball

// How far the nearest opponent is from the line of the kick, over its first `reach` metres [m].
double room_along(const kit::View& view, const Vector2d& from, double direction, double reach) {
  const world::Segment way{from, from + reach * world::direction(direction)};
  double room = 9;
  for (const kit::Robot& other : view.opponents) room = std::min(room, world::distance(way, other.position));
  return room;
}

double room_around(const kit::View& view, const Vector2d& point) {
  double room = 2;
  for (const kit::Robot& other : view.opponents) room = std::min(room, (other.position - point).norm());
  return room;
}

skills::Order kick_long(const kit::View& view, const kit::Robot& robot, const reference::Roles& roles,
                        const Style& style, const skills::Order& polite) {
  const LongKick kick = long_kick(view, roles, robot, style);
  const bool holds = kit::holds_ball(robot, view.ball, view.field().ball_radius);
  skills::Order order =
      holds ? skills::turn_and_kick(view, robot, kick.direction, kick.speed, kick.angle, tolerance)
            : skills::approach_and_kick(view, robot, kick.direction, kick.speed, kick.angle, tolerance);
  order.why = kick.angle > 0 ? "long chip" : "long ball";
  order.their_area = polite.their_area;
  order.enter_own_area = polite.enter_own_area;
  return order;
}

}  // namespace

void declare(kit::Flags& flags, Style& style) {
  flags.add("striker-x", style.striker_x, 0.5, 3.2, "how high the strikers wait [m]");
  flags.add("shooting-range", style.shooting_range, 1.0, 6.0, "distance to the goal from which to shoot [m]");
  flags.add("chip-reach", style.chip_reach, 0.0, 3.0, "opponents nearer in the way are chipped over [m]");
}

Vector2d striker_place(const kit::View& view, int index, int count, const Style& style) {
  const double y = count <= 1 ? -0.4 * view.ball.position.y() : 1.3 * (2.0 * index / (count - 1) - 1.0);
  return world::moved_out_of_defense_area(view.field(), world::Side::Positive, {style.striker_x, y}, 0.35);
}

LongKick long_kick(const kit::View& view, const reference::Roles& roles, const kit::Robot& robot,
                   const Style& style) {
  const Vector2d ball = view.ball.position;
  LongKick kick;
  double distance = 3.0;
  double best = -1;
  for (const kit::Robot& striker : view.own) {
    if (roles.of(striker.number) != reference::Role::Support || striker.number == robot.number) continue;
    const Vector2d to = striker.position - ball;
    const double room = room_around(view, striker.position);
    if (to.x() < 0.3 || room <= best) continue;
    best = room;
    kick.striker = striker.number;
    kick.direction = world::angle_of(to);
    distance = to.norm();
  }
  if (kick.striker < 0) kick.direction = -0.1 * ball.y();  // straight on, a little towards the middle
  const kit::BallModel model(view.geometry);
  kick.speed = std::clamp(model.kick_speed_for(distance, arrival), 2.0, 6.5);
  if (room_along(view, ball, kick.direction, style.chip_reach) < 0.2) {
    // At 45 degrees it carries v^2 / g and hops and rolls about as far again.
    kick.angle = M_PI / 4;
    kick.speed = std::clamp(std::sqrt(9.81 * 0.5 * distance), 2.5, fastest_chip);
  }
  return kick;
}

std::unique_ptr<kit::Team> make_team(const kit::Setup& setup, reference::Parameters parameters,
                                     const Style& style, bool notes) {
  auto team = std::make_unique<reference::ReferenceTeam>(setup, parameters, notes);
  team->revise_orders([style](const kit::View& view, const kit::Robot& robot, const reference::Roles& roles,
                              skills::Order& order) {
    const kit::Game& game = view.game;
    if (game.phase != Phase::Running) return;
    switch (roles.of(robot.number)) {
      case reference::Role::Support:
        if (game.forbidden == robot.number) return;
        order.why = "striker";
        order.target = striker_place(view, roles.index[robot.number], roles.formation.supports, style);
        return;
      case reference::Role::Winner: {
        // Near their goal, and while the ball rolls to somebody, it plays like everybody else.
        const bool close = (view.their_goal() - view.ball.position).norm() < style.shooting_range;
        const bool at_ball = (view.ball.position - robot.position).norm() < 0.3;
        const bool comes = view.ball.velocity.norm() > 1.0;
        if (close || !at_ball || comes || order.kick_speed > 6) return;
        order = kick_long(view, robot, roles, style, order);
        return;
      }
      default:
        return;
    }
  });
  return team;
}

}  // namespace longball
