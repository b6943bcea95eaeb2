#include "teams/rough/kicks.h"

#include <array>
#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/turn_dribble.h"

namespace rough {

using world::Vector2d;

Kick plan_clearance(const kit::View& view, const kit::Robot& robot) {
  const world::Field& field = view.field();
  std::array<skills::Blocker, 24> blockers;
  std::size_t count = 0;
  for (const auto* robots : {&view.own, &view.opponents}) {
    for (const kit::Robot& other : *robots) {
      if (other.position == robot.position || count == blockers.size()) continue;
      blockers[count++] = {other.position, 0.2};  // hull, ball, and half a robot's way meanwhile
    }
  }
  const double x = field.half_length();
  const double inner = field.goal_width / 2 + 0.3;
  const double outer = field.half_width() - 0.3;
  Kick plan;
  double widest = -1;
  for (const double side : {1.0, -1.0}) {
    const skills::Opening opening =
        skills::widest_opening(view.ball.position, {{x, side * inner}, {x, side * outer}},
                               std::span(blockers.data(), count), robot.orientation, 0.1);
    if (opening.width <= widest) continue;
    widest = opening.width;
    plan.direction = opening.width > 0
                         ? opening.direction
                         : world::angle_of(Vector2d(x, side * (inner + outer) / 2) - view.ball.position);
  }
  const bool free = widest > 0.06;
  plan.speed = 6.5;
  plan.angle = free ? 0 : 0.5;  // 3.6 m through the air
  return plan;
}

skills::Order clear_from_rest(const kit::View& view, const kit::Robot& robot) {
  const Kick plan = plan_clearance(view, robot);
  skills::Order order = skills::approach_and_kick(view, robot, plan.direction, plan.speed, plan.angle, 0.05);
  order.why = "clear away";
  return order;
}

std::optional<Kick> plan_feeding(const kit::View& view) {
  const kit::Robot* own = kit::find(view.own, view.game.own_keeper);
  const kit::Robot* theirs = kit::find(view.opponents, view.game.their_keeper);
  const auto away = [&](const kit::Robot* goalie) {
    return goalie != nullptr ? (goalie->position - view.ball.position).norm() : 99;
  };
  const kit::Robot* goalie = away(own) < away(theirs) ? own : theirs;
  if (goalie == nullptr) return {};
  const Vector2d way = goalie->position - view.ball.position;
  // The ball rolls with 5/7 of the kick's speed and loses 0.26 m/s^2: 0.6 m/s are left.
  return Kick{world::angle_of(way), 1.4 * std::sqrt(0.36 + 0.52 * way.norm()), 0};
}

skills::Order clear_from_dribbler(const kit::View& view, const kit::Robot& robot, const Stretch& stretch) {
  const Kick plan = plan_clearance(view, robot);
  skills::Order order = skills::turn_and_kick(view, robot, plan.direction, plan.speed, plan.angle, 0.1, 6);
  const double x = view.ball.position.x();
  if (order.kick_speed > 0 && (x < stretch.from || x > stretch.to)) {
    order = skills::carry(robot, plan.direction, x < stretch.from ? 0.4 : -0.3);
  }
  order.why = "clear away";
  return order;
}

}  // namespace rough
