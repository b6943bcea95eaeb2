#include "teams/skills/pass.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/motion.h"

namespace skills {
namespace {

constexpr double reaction = 0.1;     // [s] of an opponent (reference "football", 2.6: 0.08 to 0.12)
constexpr double most_margin = 0.5;  // [s] nobody is ever safer than that: a chance of 0.993
constexpr double gravity = 9.81;     // [m/s^2]

double chance_of(double margin) { return 1 / (1 + std::exp(-margin / 0.1)); }

// An opponent as the pass sees it.
struct Chaser {
  const kit::Robot& robot;
  Limits limits;
  double reach;  // [m]
  double fast;   // [m/s] no component of its velocity is greater
};

Chaser chaser(const kit::View& view, const kit::Robot& robot) {
  return {robot, driving_limits(robot.specs), robot.specs.radius + view.field().ball_radius,
          std::abs(robot.velocity.x()) + std::abs(robot.velocity.y())};
}

// The most it can cover in that time [m].
double range(const Chaser& c, double time) {
  if (time <= 0) return 0;
  return std::min(c.fast + 0.5 * c.limits.acceleration * time, std::max(c.limits.speed, c.fast)) * time;
}

// The lesser of `least` and the opponent's time to a point minus the ball's [s].
double least_margin(const Chaser& c, const Vector2d& point, double ball_time, double least) {
  const Vector2d to = point - c.robot.position;
  // Most could not be there in time even driving straight at it: no roots needed.
  const double far = c.reach + range(c, ball_time + least - reaction);
  if (to.squaredNorm() > far * far) return least;
  const double drive = time_to_touch(to, c.robot.velocity, c.limits, c.reach);
  // Who stands there need not react.
  return std::min(least, (drive > 0 ? reaction + drive : 0) - ball_time);
}

}  // namespace

double pass_safety(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                   const Vector2d& to, double speed) {
  const Vector2d way = to - from;
  const double length = way.norm();
  if (length < 0.05) return 1;
  const Vector2d along = way / length;
  const double rolls = model.switch_ratio * speed;
  const double whole = model.time_to_cover(speed, rolls, length);
  double least = most_margin;
  for (const kit::Robot& opponent : view.opponents) {
    const Vector2d at = opponent.position - from;
    const double abreast = at.dot(along);
    if (abreast < -0.3) continue;
    // Not even to the nearest point of the line by the time the ball is at its end.
    const Chaser c = chaser(view, opponent);
    const double beside = along.x() * at.y() - along.y() * at.x();
    if (std::abs(beside) > c.reach + range(c, whole + least - reaction)) continue;
    least = least_margin(c, to, whole, least);
    const double nearest = std::clamp(abreast, 0.2, std::max(length, 0.2));
    for (const double s : {nearest, 0.5 * (nearest + length)}) {
      if (s >= length) continue;
      const double time = model.time_to_cover(speed, rolls, s);
      least = least_margin(c, from + along * s, time, least);
    }
  }
  return chance_of(least);
}

Pass plan_pass(const kit::View& view, const kit::BallModel& model, const Vector2d& from, const Vector2d& to,
               double arrival) {
  Pass pass;
  pass.target = to;
  const double length = (to - from).norm();
  pass.speed = std::clamp(model.kick_speed_for(length, arrival), 2.0, 6.5);
  pass.time = model.time_to_cover(pass.speed, model.switch_ratio * pass.speed, length);
  pass.safety = pass_safety(view, model, from, to, pass.speed);
  return pass;
}

std::optional<Pass> plan_chip(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                              const Vector2d& to) {
  const Vector2d way = to - from;
  const double length = way.norm();
  if (length < 0.8) return {};
  const Vector2d along = way / length;
  const double ball_radius = view.field().ball_radius;
  // At 45 degrees the ball is at x - x^2 / carry: 0.2 m after the kick it is above a robot.
  constexpr double rise = 0.2;
  double beyond = -1;  // [m] the end of the last robot in the way near the ball
  for (const kit::Robot& opponent : view.opponents) {
    const Vector2d at = opponent.position - from;
    const double ahead = at.dot(along);
    const double beside = std::abs(along.x() * at.y() - along.y() * at.x());
    if (ahead < 0 || ahead > 1.5 || beside > opponent.specs.radius + ball_radius + 0.03) continue;
    if (ahead - opponent.specs.radius < rise) return {};  // too near to be chipped over
    beyond = std::max(beyond, ahead + opponent.specs.radius);
  }
  if (beyond < 0) return {};
  const double carry = std::max(beyond + 0.3, std::min(0.6 * length, 2.5));
  if (carry > length - 0.2) return {};
  Pass pass;
  pass.target = to;
  pass.angle = M_PI / 4;
  pass.speed = std::sqrt(gravity * carry);
  const double across = pass.speed * std::sqrt(0.5);  // horizontal and vertical speed [m/s]
  const double flight = 2 * across / gravity;
  const double rolling = 5.0 / 7.0 * across;
  double least = most_margin;
  for (const double s : {carry, 0.5 * (carry + length), length}) {
    const double time = flight + model.time_to_cover(rolling, rolling, s - carry);
    if (s >= length) pass.time = time;
    for (const kit::Robot& opponent : view.opponents) {
      least = least_margin(chaser(view, opponent), from + along * s, time, least);
    }
  }
  if (!std::isfinite(pass.time)) return {};
  pass.safety = chance_of(least);
  return pass;
}

}  // namespace skills
