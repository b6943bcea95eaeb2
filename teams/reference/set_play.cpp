#include "teams/reference/set_play.h"

#include <cmath>

namespace reference {
namespace {

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
    case SetPlay::Penalty:
      return "penalty";
  }
  return "unknown";
}

SetPlay set_play(const kit::View& view) {
  const kit::Game& game = view.game;
  if (!game.ours) return SetPlay::None;
  if (game.phase == kit::Phase::PrepareKickoff || game.phase == kit::Phase::Kickoff) return SetPlay::Kickoff;
  if (game.phase == kit::Phase::PreparePenalty || game.phase == kit::Phase::Penalty) return SetPlay::Penalty;
  const Vector2d ball = view.ball.position;
  const world::Field& field = view.field();
  if (is_free_kick(game.phase) && ball.x() > field.half_length() - 0.6 &&
      std::abs(ball.y()) > field.half_width() - 1.0) {
    return SetPlay::Corner;
  }
  return SetPlay::None;
}

std::optional<Vector2d> set_play_place(const kit::View& view, int index, int count) {
  const world::Field& field = view.field();
  const double near = view.ball.position.y() > 0 ? 1.0 : -1.0;  // the ball's side
  const double goal_line = field.half_length();
  switch (set_play(view)) {
    case SetPlay::Kickoff: {
      if (index > 1) return {};
      const double side = count == 1 ? near : index == 0 ? 1.0 : -1.0;
      return Vector2d(-0.2, side * 0.5 * field.half_width());
    }
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
  if (set_play(view) == SetPlay::Kickoff) return {0.1, place.y()};
  return place;
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
