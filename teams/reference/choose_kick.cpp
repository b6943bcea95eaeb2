#include "teams/reference/choose_kick.h"

#include <algorithm>
#include <cmath>

#include "teams/reference/reception.h"
#include "teams/skills/aim.h"
#include "teams/skills/motion.h"
#include "teams/skills/pass.h"

namespace reference {
namespace {

// A kick that only has to be away: upfield, where the opponents leave most room and the
// ball stays on the field.
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

double time_to_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot) {
  if (kit::holds_ball(robot, view.ball, view.field().ball_radius)) return 0;
  // A meeting is planned with reserve; who is at the ball already takes it at 0.5 m/s or more.
  const double gap = (view.ball.position - robot.position).norm() - robot.specs.radius;
  return std::min(situation.meetings[robot.number].time, std::max(gap, 0.0) / 0.5);
}

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

namespace {

constexpr double keep = 0.05;         // of value, in favour of the choice before
constexpr double slow_arrival = 1.2;  // [m/s] of a pass to one who would be late
constexpr double notices = 0.1;       // [s] until the receiver sees that the ball was kicked

std::optional<Kick> shot(const kit::View& view, int kicker, const Parameters& parameters,
                         const std::optional<Kick>& before) {
  const Vector2d ball = view.ball.position;
  std::optional<double> aimed;
  if (before && before->kind == Kick::Kind::Shot) aimed = before->direction;
  const skills::Opening opening = skills::opening_to_goal(view, ball, parameters.shot_speed, kicker, aimed);
  const double chance = goal_chance(opening.width, (view.their_goal() - ball).norm(), is_guarded(view));
  const double bonus = aimed ? keep : 0;
  if (chance + bonus <= parameters.shot_threshold) return {};
  Kick kick;
  kick.kind = Kick::Kind::Shot;
  kick.target = opening.target;
  kick.direction = opening.direction;
  kick.speed = parameters.shot_speed;
  kick.tolerance = skills::kick_tolerance(opening.width);
  // A shot now is worth more than the same later.
  kick.value = parameters.shot_bonus + (1 - parameters.shot_bonus) * chance + bonus;
  return kick;
}

// The pass to one point, flat, or chipped where the ground line is blocked.
std::optional<Kick> pass_to(const kit::View& view, const Situation& situation, const kit::Robot& kicker,
                            const kit::Robot& mate, const Vector2d& target, const KickRules& rules) {
  const Vector2d ball = view.ball.position;
  const double length = (target - ball).norm();
  if (length < 0.8 || length > 7.0) return {};
  // A kicker that kicks more sideways stands beyond the halfway line itself.
  if (rules.must_go_forward && target.x() - ball.x() < 0.5 * length) return {};
  // Across the own goal is how games are lost.
  if (target.x() < -2.5 && ball.x() > target.x()) return {};
  Kick kick;
  kick.kind = Kick::Kind::Pass;
  kick.target = target;
  kick.direction = world::angle_of(target - ball);
  kick.receiver = mate.number;
  kick.tolerance = std::clamp(0.12 / length, 0.03, 0.12);
  const double turn = std::abs(world::wrap_angle(kick.direction - kicker.orientation));
  const double kick_time = time_to_ball(view, situation, kicker) + turn / 8.0;  // [rad/s] of a turn
  const double own = notices + skills::travel_time(target - mate.position, mate.velocity,
                                                   skills::driving_limits(mate.specs));
  const auto consider = [&](const Reception& reception, double speed, double angle) {
    const double value = reception.value() * reach_chance(own, kick_time + reception.ball_time);
    if (value <= kick.value) return;
    kick.value = value;
    kick.speed = speed;
    kick.angle = angle;
  };
  Reception reception = reception_at(view, situation.model, ball, target, mate.number);
  consider(reception, reception.speed, 0);
  if (own > kick_time + reception.ball_time) {
    const Reception slow = reception_at(view, situation.model, ball, target, mate.number, slow_arrival);
    consider(slow, slow.speed, 0);
  }
  if (reception.safety < 0.5) {
    if (const auto chip = skills::plan_chip(view, situation.model, ball, target)) {
      reception.safety = 0.7 * chip->safety;  // a hopping ball is harder to take (ours)
      reception.ball_time = chip->time;
      consider(reception, chip->speed, chip->angle);
    }
  }
  return kick;
}

}  // namespace

Kick choose_kick(const kit::View& view, const Situation& situation, int kicker_number, const KickRules& rules,
                 const Parameters& parameters, const std::optional<Kick>& before) {
  const Vector2d ball = view.ball.position;
  Kick best;
  best.value = -1;
  if (rules.shot_allowed) {
    if (const auto kick = shot(view, kicker_number, parameters, before)) best = *kick;
  }
  const double threshold = rules.must_kick && !rules.otherwise ? 0.04
                           : rules.otherwise                   ? 0.06
                                                               : parameters.pass_threshold;
  const kit::Robot* kicker = kit::find(view.own, kicker_number);
  for (const kit::Robot& mate : view.own) {
    if (kicker == nullptr || mate.number == kicker_number || mate.number == view.game.own_keeper) continue;
    const auto given =
        std::find_if(rules.targets.begin(), rules.targets.end(),
                     [&mate](const PassTarget& target) { return target.receiver == mate.number; });
    if (rules.only_targets && given == rules.targets.end()) continue;
    // Without a place of its own: where it is going, and a little towards their goal.
    const Vector2d target = given != rules.targets.end()
                                ? given->point
                                : Vector2d(mate.position + 0.3 * mate.velocity + Vector2d(0.1, 0));
    auto kick = pass_to(view, situation, *kicker, mate, target, rules);
    if (!kick) continue;
    const bool kept = before && before->kind == Kick::Kind::Pass && before->receiver == mate.number;
    if (kept) kick->value += keep;
    if (kick->value > best.value && kick->value >= threshold) best = *kick;
  }
  if (best.value > 0) return best;

  if (rules.otherwise) return *rules.otherwise;
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
  return clearance(view, situation, kicker_number, ball.x() > -2);
}

}  // namespace reference
