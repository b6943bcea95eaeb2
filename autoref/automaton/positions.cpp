#include "autoref/automaton/positions.h"

#include <algorithm>
#include <cmath>

namespace automaton {

using world::Vector2d;

namespace {

// The point itself, or the nearest one `inset` inside the lines.
Vector2d clamped(const world::Field& field, const Vector2d& place, double inset) {
  const double x = field.half_length() - inset;
  const double y = field.half_width() - inset;
  return {std::clamp(place.x(), -x, x), std::clamp(place.y(), -y, y)};
}

}  // namespace

Vector2d free_kick_position(const world::RuleSet& rules, const world::GameState& state, world::Team team,
                            const Vector2d& place) {
  const world::Field& field = rules.field;
  Vector2d result = clamped(field, place, rules.touch_line_inset);
  for (const world::Side side : {world::Side::Negative, world::Side::Positive}) {
    if (world::distance_to_defense_area(field, side, result) > 0) continue;
    result = {world::sign(side) * (field.half_length() - rules.free_kick_goal_line),
              std::copysign(field.half_width() - rules.touch_line_inset, result.y())};
  }
  const world::Side attacked = world::other(world::defended_side(state, team));
  result = world::moved_out_of_defense_area(field, attacked, result, rules.free_kick_area_distance);
  return clamped(field, result, rules.touch_line_inset);
}

Vector2d neutral_position(const world::RuleSet& rules, const Vector2d& place) {
  Vector2d result = clamped(rules.field, place, rules.touch_line_inset);
  for (const world::Side side : {world::Side::Negative, world::Side::Positive}) {
    result = world::moved_out_of_defense_area(rules.field, side, result, rules.free_kick_area_distance);
  }
  return clamped(rules.field, result, rules.touch_line_inset);
}

Vector2d kick_in_position(const world::RuleSet& rules, const Vector2d& crossing) {
  const Vector2d inside = clamped(rules.field, crossing, rules.touch_line_inset);
  return {inside.x(), std::copysign(rules.field.half_width() - rules.touch_line_inset, crossing.y())};
}

Vector2d goal_line_position(const world::RuleSet& rules, const Vector2d& crossing, bool corner) {
  const double inset = corner ? rules.corner_inset : rules.goal_kick_inset;
  return {std::copysign(rules.field.half_length() - inset, crossing.x()),
          std::copysign(rules.field.half_width() - rules.corner_inset, crossing.y())};
}

Vector2d penalty_mark(const world::RuleSet& rules, const world::GameState& state, world::Team defending) {
  const double distance = rules.field.half_length() - rules.field.penalty_mark_distance;
  return {world::sign(world::defended_side(state, defending)) * distance, 0};
}

}  // namespace automaton
