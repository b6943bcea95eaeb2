#include "teams/reference/choose_kick.h"

#include <algorithm>
#include <cmath>

#include "teams/skills/aim.h"
#include "teams/skills/pass.h"

namespace reference {
namespace {

// From farther than this [m] a shot is no threat: the goalie has all the time (ours).
constexpr double far_shot = 5.5;

double chance_of_goal(const skills::Opening& opening, double distance) {
  const double far = std::clamp((far_shot - distance) / 2.0, 0.0, 1.0);
  return std::min(1.0, opening.width / 0.3) * far;  // 0.3 rad: reference "football", 2.5
}

// A kick that only has to be away: upfield, where the opponents leave most room and the ball stays on the
// field.
Kick clearance(const kit::View& view, const Situation& situation, int kicker, bool gentle) {
  const Vector2d ball = view.ball.position;
  const double reach = 3.0;  // [m] blockers beyond do not matter; here it should be taken by somebody
  std::array<skills::Blocker, 16> blockers;
  std::size_t count = 0;
  for (const kit::Robot& robot : view.opponents) {
    if (count < blockers.size()) blockers[count++] = {robot.position, 0.25};
  }
  for (const kit::Robot& robot : view.own) {
    if (robot.number != kicker && count < blockers.size()) blockers[count++] = {robot.position, 0.1};
  }
  // 60 degrees to either side of straight on, less where the touch line is nearer.
  const double room = view.field().half_width() - 0.4;
  const double left = std::clamp(std::asin(std::clamp((room - ball.y()) / reach, -1.0, 1.0)), -0.8, 1.0);
  const double right = std::clamp(std::asin(std::clamp((-room - ball.y()) / reach, -1.0, 1.0)), -1.0, 0.8);
  const skills::Opening opening = skills::widest_opening(
      ball,
      {ball + reach * world::direction(std::min(right, left - 0.2)), ball + reach * world::direction(left)},
      std::span(blockers.data(), count));
  Kick kick;
  kick.kind = Kick::Kind::Clear;
  kick.direction = opening.direction;
  kick.target = ball + reach * world::direction(kick.direction);
  // Balls roll far (0.26 m/s^2): just fast enough to get past those near, unless our goal is in danger.
  kick.speed = situation.model.kick_speed_for(reach, gentle ? 0.5 : 1.2);
  kick.tolerance = 0.25;
  return kick;
}

}  // namespace

const char* name(Kick::Kind kind) {
  switch (kind) {
    case Kick::Kind::Shot:
      return "shot";
    case Kick::Kind::Pass:
      return "pass";
    case Kick::Kind::Clear:
      return "clear";
    case Kick::Kind::Dribble:
      return "dribble";
  }
  return "unknown";
}

double value_at(const kit::View& view, const Vector2d& point, int shooter) {
  const double distance = (view.their_goal() - point).norm();
  double shot = 0;
  if (distance < far_shot) {
    shot = chance_of_goal(skills::opening_to_goal(view, point, 6.5, shooter), distance);
  }
  const double up = std::clamp((point.x() + view.field().half_length()) / view.field().length, 0.0, 1.0);
  return 0.7 * shot + 0.3 * up;
}

Kick choose_kick(const kit::View& view, const Situation& situation, int kicker, KickRules rules,
                 const Parameters& parameters, const std::optional<Kick>& before) {
  const Vector2d ball = view.ball.position;
  const double keep = 0.05;  // in favour of the choice before

  Kick best;
  best.value = -1;

  if (rules.shot_allowed) {
    std::optional<double> aimed;
    if (before && before->kind == Kick::Kind::Shot) aimed = before->direction;
    const skills::Opening opening = skills::opening_to_goal(view, ball, parameters.shot_speed, kicker, aimed);
    const double chance = chance_of_goal(opening, (view.their_goal() - ball).norm());
    const double bonus = aimed ? keep : 0;
    if (chance + bonus > parameters.shot_threshold) {
      best.kind = Kick::Kind::Shot;
      best.target = opening.target;
      best.direction = opening.direction;
      best.speed = parameters.shot_speed;
      best.tolerance = skills::kick_tolerance(opening.width);
      best.value = 0.3 + 0.7 * chance + bonus;  // a shot now is worth more than the same later
    }
  }

  for (const kit::Robot& mate : view.own) {
    if (mate.number == kicker || mate.number == view.game.own_keeper) continue;
    // Lead the receiver a little, and towards their goal.
    const Vector2d target = mate.position + 0.3 * mate.velocity + Vector2d(0.1, 0);
    const double length = (target - ball).norm();
    if (length < 0.8 || length > 6.0) continue;
    if (rules.must_go_forward && target.x() < ball.x() + 0.2) continue;
    // Across the own goal is how games are lost.
    if (target.x() < -2.5 && ball.x() > target.x()) continue;
    const skills::Pass pass = skills::plan_pass(view, situation.model, ball, target);
    const bool kept = before && before->kind == Kick::Kind::Pass && before->receiver == mate.number;
    const double value = pass.safety * value_at(view, target, mate.number) + (kept ? keep : 0);
    if (value <= best.value || value < (rules.must_kick ? 0.04 : parameters.pass_threshold)) continue;
    best.kind = Kick::Kind::Pass;
    best.target = target;
    best.direction = world::angle_of(target - ball);
    best.speed = pass.speed;
    best.tolerance = std::clamp(0.12 / length, 0.03, 0.12);
    best.receiver = mate.number;
    best.value = value;
  }
  if (best.value > 0) return best;

  const double hurry = situation.their_time;
  if (!rules.must_kick && (hurry > 0.7 || ball.x() > 1.0)) {
    // Nobody near: carry it forward, a little towards the middle in front of their goal.
    Kick carry;
    carry.kind = Kick::Kind::Dribble;
    carry.target = view.their_goal() - Vector2d(1.2, 0);
    carry.direction = world::angle_of(view.their_goal() - ball);
    carry.value = 0;
    return carry;
  }
  return clearance(view, situation, kicker, ball.x() > -2);
}

}  // namespace reference
