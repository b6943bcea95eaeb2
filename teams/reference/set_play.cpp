#include "teams/reference/set_play.h"

#include <algorithm>
#include <cmath>

namespace reference {
namespace {

constexpr double tap_direction = 1.0;    // [rad] off straight on: the kicker stays in its half
constexpr double tap_speed = 1.0;        // [m/s] slow enough to be taken 0.3 m farther on (ours)
constexpr double goal_kick_depth = 1.0;  // [m]

bool is_free_kick(kit::Phase phase) {
  return phase == kit::Phase::DirectFree || phase == kit::Phase::IndirectFree;
}

}  // namespace

const char* name(SetPlay play) {
  switch (play) {
    case SetPlay::None:
      return "none";
    case SetPlay::Kickoff:
      return "kickoff";
    case SetPlay::Corner:
      return "corner";
    case SetPlay::GoalKick:
      return "goal kick";
    case SetPlay::NeutralStart:
      return "neutral start";
    case SetPlay::Penalty:
      return "penalty";
  }
  return "unknown";
}

SetPlay set_play(const kit::View& view) {
  const kit::Game& game = view.game;
  if (game.phase == kit::Phase::Running && !game.forbidden && !game.indirect &&
      (view.ball.position - game.restart_position).norm() < 0.05 && view.ball.velocity.norm() < 0.2) {
    return SetPlay::NeutralStart;
  }
  if (!game.ours) return SetPlay::None;
  if (game.phase == kit::Phase::PrepareKickoff || game.phase == kit::Phase::Kickoff) return SetPlay::Kickoff;
  if (game.phase == kit::Phase::PreparePenalty || game.phase == kit::Phase::Penalty) return SetPlay::Penalty;
  const Vector2d ball = view.ball.position;
  const world::Field& field = view.field();
  if (is_free_kick(game.phase) && ball.x() > field.half_length() - 0.6 &&
      std::abs(ball.y()) > field.half_width() - 1.0) {
    return SetPlay::Corner;
  }
  if (is_free_kick(game.phase) && ball.x() < goal_kick_depth - field.half_length()) return SetPlay::GoalKick;
  return SetPlay::None;
}

std::optional<Vector2d> set_play_place(const kit::View& view, int index) {
  const world::Field& field = view.field();
  const double near = view.ball.position.y() > 0 ? 1.0 : -1.0;  // the ball's side
  const double goal_line = field.half_length();
  switch (set_play(view)) {
    case SetPlay::Kickoff: {
      // Beside the ball as near as our own may come, then the wings.
      if (index == 0) return Vector2d(-0.19, 0.4);
      if (index > 2) return {};
      const double side = index == 1 ? -1.0 : 1.0;
      return Vector2d(-0.2, side * 0.5 * field.half_width());
    }
    case SetPlay::GoalKick:
      if (index == 0) return Vector2d(view.ball.position.x() + 2.2, near * (field.half_width() - 0.5));
      if (index == 1) return Vector2d(view.ball.position.x() + 3.6, near * 0.35 * field.half_width());
      if (index == 2) return Vector2d(0.5, -near * 0.5 * field.half_width());
      return {};
    case SetPlay::NeutralStart:
      if (index == 0) {
        const Vector2d home = (view.own_goal() - view.ball.position).normalized();
        return Vector2d(view.ball.position + 0.8 * home);
      }
      return {};
    case SetPlay::Corner:
      if (index == 0) return Vector2d(goal_line - 1.5, -near * 0.9);   // far post
      if (index == 1) return Vector2d(goal_line - 1.35, near * 0.95);  // the edge at 45 degrees
      if (index == 2) return Vector2d(goal_line - 2.0, near * (field.half_width() - 0.7));  // decoy
      return {};
    case SetPlay::Penalty: {
      if (index > 1) return {};
      const double side = index == 0 ? 1.0 : -1.0;
      return Vector2d(goal_line - field.penalty_mark_distance - 0.7, side * 0.9);
    }
    case SetPlay::None:
      break;
  }
  return {};
}

Vector2d set_play_target(const kit::View& view, const Vector2d& place) {
  // The kickoff goes into their half, where the runner meets it.
  if (set_play(view) != SetPlay::Kickoff) return place;
  if (std::abs(place.y()) < 1.0) return {0.2, std::copysign(0.2 * std::tan(tap_direction), place.y())};
  return {0.95, place.y()};
}

std::optional<Kick> set_kick(const kit::View& view, std::span<const PassTarget> targets) {
  if (set_play(view) != SetPlay::Kickoff) return {};
  const auto beside = std::min_element(targets.begin(), targets.end(), [](const auto& a, const auto& b) {
    return a.point.norm() < b.point.norm();
  });
  if (beside == targets.end() || beside->point.norm() > 0.8) return {};
  Kick tap;
  tap.kind = Kick::Kind::Pass;
  tap.target = beside->point;
  tap.direction = world::angle_of(beside->point - view.ball.position);
  tap.speed = tap_speed;
  tap.tolerance = 0.15;
  tap.receiver = beside->receiver;
  return tap;
}

Kick long_goal_kick(const kit::View& view) {
  const Vector2d ball = view.ball.position;
  const double near = ball.y() > 0 ? 1.0 : -1.0;
  Kick kick;
  kick.kind = Kick::Kind::Clear;
  kick.target = {0, near * (view.field().half_width() - 0.9)};
  kick.direction = world::angle_of(kick.target - ball);
  // [m/s] 1.3 m through the air, over who stands in front; 4.2 rolled over their goal line from farther up.
  kick.speed = 3.6;
  kick.angle = M_PI / 4;
  kick.tolerance = 0.1;
  return kick;
}

double penalty_direction(const kit::View& view) {
  const world::Field& field = view.field();
  const kit::Robot* goalie = kit::find(view.opponents, view.game.their_keeper);
  const double offset = goalie != nullptr ? goalie->position.y() : 0;
  // 0.1 m inside the post: ball radius, and three standard errors of a kick of 0.02 rad from 1 m (ours).
  const double y = field.goal_width / 2 - 0.1;
  const Vector2d target(field.half_length(), offset > 0 ? -y : y);
  return world::angle_of(target - view.ball.position);
}

}  // namespace reference
