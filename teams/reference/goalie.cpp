#include "teams/reference/goalie.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/ball_handling.h"
#include "teams/skills/motion.h"
#include "teams/skills/pass.h"
#include "teams/skills/turn_dribble.h"

namespace reference {
namespace {

// [m] of the guarding goalie to the goal line, on the ball's line (ours)
constexpr double nearest_out = 0.25;
constexpr double farthest_out = 0.8;  // [m] farther out a pass across finds the goal empty (ours)
constexpr double beside_post = 0.5;  // [m] out on a flank the line to the ball leaves the goal's width (ours)
constexpr double safe_pass = 0.75;   // [0..1] from which a clearance is a pass (ours)
constexpr double clearing_speed = 4.2;  // [m/s] a chip at 45 degrees: 1.8 m through the air; more rolls off

// The ball rolls towards our goal mouth: where its line crosses the goal line, or nothing.
std::optional<Vector2d> shot_crossing(const kit::View& view, const Situation& situation) {
  const kit::Ball& ball = view.ball;
  const double speed = ball.velocity.norm();
  if (speed < 0.5 || ball.velocity.x() > -0.2) return {};
  const double x = -view.field().half_length();
  const double t = (x - ball.position.x()) / ball.velocity.x();  // in units of the velocity
  if (t < 0) return {};
  const Vector2d crossing = ball.position + t * ball.velocity;
  if (std::abs(crossing.y()) > view.field().goal_width / 2 + 0.15) return {};
  if (situation.model.stopping_distance(speed, ball.rolls_below) < (crossing - ball.position).norm())
    return {};
  return crossing;
}

// The point of the shot's line in front of the goal where the goalie has the most time to spare.
Vector2d save_position(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                       const Vector2d& crossing) {
  const kit::Ball& ball = view.ball;
  const double speed = ball.velocity.norm();
  const Vector2d along = ball.velocity / speed;
  const double to_line = (crossing - ball.position).norm();
  const skills::Limits limits = skills::driving_limits(robot.specs);
  Vector2d best = crossing - along * 0.1;
  double most = -1e9;
  for (int i = 0; i <= 10; ++i) {
    const double s = to_line - 0.08 - 0.1 * i;  // [m] along the ball's way, from the goal line out
    if (s < 0) break;
    const Vector2d point = ball.position + along * s;
    const double ball_time = situation.model.time_to_cover(speed, ball.rolls_below, s);
    const double own_time =
        skills::time_to_touch(point - robot.position, robot.velocity, limits, 0.5 * robot.specs.radius);
    const double slack = ball_time - own_time - 0.01 * i;
    if (slack > most) {
      most = slack;
      best = point;
    }
  }
  return best;
}

}  // namespace

Vector2d guard_position(const kit::View& view, const kit::Robot& robot) {
  const world::Field& field = view.field();
  const Vector2d goal = view.own_goal();
  const double half = field.goal_width / 2;
  const Vector2d ball = view.ball.position;
  // What our own robots leave open of the goal; all of it when the ball is far or they leave nothing.
  std::array<skills::Blocker, 16> blockers;
  std::size_t count = 0;
  for (const kit::Robot& mate : view.own) {
    if (mate.number == robot.number || count == blockers.size()) continue;
    blockers[count++] = {mate.position, mate.specs.radius + field.ball_radius};
  }
  const world::Segment mouth{{goal.x(), -half}, {goal.x(), half}};
  const double stays = world::angle_of(robot.position - ball);
  skills::Opening open = skills::widest_opening(ball, mouth, std::span(blockers.data(), count), stays, 0.05);
  if (open.width < 0.05 || ball.x() > 0) open = skills::widest_opening(ball, mouth, {});
  const Vector2d cut = open.target;
  const Vector2d out = ball - cut;
  const double distance = out.norm();
  if (distance < 1e-6) return goal + Vector2d(0.3, 0);
  // A disc closes the opening when it is this near to the ball (reference "football", 2.7).
  const double closes =
      (robot.specs.radius + field.ball_radius) / std::sin(std::clamp(0.5 * open.width, 0.05, 1.5));
  Vector2d place =
      cut +
      out / distance * std::min(std::clamp(distance - closes, nearest_out, farthest_out), distance * 0.7);
  place.x() = std::max(place.x(), goal.x() + robot.specs.radius + 0.02);
  place.y() = std::clamp(place.y(), -half - beside_post, half + beside_post);
  return place;
}

bool goes_out(const kit::View& view, const Situation& situation, const kit::Robot& robot) {
  constexpr double before_them = 0.1;  // [s] reference "football", 2.7
  constexpr double farthest = 1.5;     // [m] from the area (ours)
  const skills::Meeting& own = situation.meetings[robot.number];
  const double away = world::distance_to_defense_area(view.field(), world::Side::Negative, own.position);
  if (away > farthest || own.time > situation.their_time - before_them) return false;
  for (const kit::Robot& mate : view.own) {
    if (mate.number != robot.number && situation.meetings[mate.number].time < own.time + 0.3) return false;
  }
  // Only when they come alone for it; a free ball far from everybody is the field players' business.
  return situation.their_time < 2.0;
}

bool may_leave_goal(const kit::View& view, const Situation& situation, const kit::Robot& robot) {
  if (view.game.forbidden == robot.number || shot_crossing(view, situation)) return false;
  // In its area it clears the ball as any goalie does.
  if (world::distance_to_defense_area(view.field(), world::Side::Negative, view.ball.position) < 0.1)
    return false;
  const skills::Meeting& own = situation.meetings[robot.number];
  // A lost ball costs the way back: 0.2 s near the goal, 0.15 s more for every metre (ours).
  const double needed = 0.2 + 0.15 * (own.position - view.own_goal()).norm();
  // Nobody comes for a ball at rest: somebody must.
  const bool nobody = view.ball.velocity.norm() < 0.3 && situation.their_time > 1.5;
  return own.time + needed < situation.their_time || (nobody && own.time < situation.their_time + 0.2) ||
         kit::holds_ball(robot, view.ball, view.field().ball_radius);
}

skills::Order clear_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot) {
  const kit::Ball& ball = view.ball;
  // To a free mate when that is safe.
  const kit::Robot* receiver = nullptr;
  skills::Pass pass;
  pass.safety = safe_pass;
  for (const kit::Robot& mate : view.own) {
    const Vector2d to = mate.position - ball.position;
    if (mate.number == robot.number || to.norm() < 1.2 || to.norm() > 5.0 || to.x() < 0.3) continue;
    const skills::Pass candidate = skills::plan_pass(view, situation.model, ball.position, mate.position);
    if (candidate.safety > pass.safety) {
      pass = candidate;
      receiver = &mate;
    }
  }
  double direction = 0, speed = 0, angle = 0, tolerance = 0.3;
  if (receiver != nullptr) {
    direction = world::angle_of(pass.target - ball.position);
    speed = pass.speed;
    tolerance = 0.05;
  } else {
    // Away with it over their heads, to the side where nobody stands.
    std::array<skills::Blocker, 24> blockers;
    std::size_t count = 0;
    for (const auto* robots : {&view.own, &view.opponents}) {
      for (const kit::Robot& other : *robots) {
        if (other.position == robot.position || count == blockers.size()) continue;
        blockers[count++] = {other.position, 0.2};
      }
    }
    const skills::Opening opening = skills::widest_opening(
        ball.position,
        {ball.position + 3 * world::direction(-1.0), ball.position + 3 * world::direction(1.0)},
        std::span(blockers.data(), count));
    direction = opening.direction;
    speed = clearing_speed;
    angle = M_PI / 4;
  }
  const bool holds = kit::holds_ball(robot, ball, view.field().ball_radius);
  skills::Order order = holds ? skills::turn_and_kick(view, robot, direction, speed, angle, tolerance)
                              : skills::approach_and_kick(view, robot, direction, speed, angle, tolerance);
  order.enter_own_area = true;
  order.why = receiver != nullptr ? "pass out" : "clear";
  return order;
}

skills::Order play_goalie(const kit::View& view, const Situation& situation, const kit::Robot& robot) {
  const kit::Ball& ball = view.ball;
  const world::Field& field = view.field();
  skills::Order order;
  order.enter_own_area = true;
  order.robot_margin = 0.0;
  order.heading = world::angle_of(ball.position - robot.position);

  if (const auto crossing = shot_crossing(view, situation)) {
    order.why = "save";
    order.target = save_position(view, situation, robot, *crossing);
    order.heading = world::angle_of(-ball.velocity);
    order.dribble = true;
    return order;
  }
  const bool playable = view.game.phase == kit::Phase::Running && view.game.forbidden != robot.number &&
                        world::distance_outside_lines(field, ball.position) < 0;
  const bool slow = ball.velocity.norm() < 1.0;
  const double in_area = world::distance_to_defense_area(field, world::Side::Negative, ball.position);
  if (playable && slow && in_area < 0.1) return clear_ball(view, situation, robot);
  if (playable && slow && goes_out(view, situation, robot)) {
    order = clear_ball(view, situation, robot);
    order.why = "go out";
    return order;
  }
  order.why = "guard";
  order.target = guard_position(view, robot);
  return order;
}

}  // namespace reference
