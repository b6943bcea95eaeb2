#pragma once

#include "sim/world/game_state.h"
#include "sim/world/rules/rule_set.h"

namespace automaton {

/// Where a free kick for `team` is taken that is due at `place`: the nearest point the laws allow.
///
/// At least `touch_line_inset` inside the lines; inside a defense area: `free_kick_goal_line` from the goal
/// line and `touch_line_inset` from the nearer touch line; within `free_kick_area_distance` of the opponents'
/// area: moved out to that distance.
///
/// Source  laws of 2015, Law 13 (R-R15-3)
world::Vector2d free_kick_position(const world::RuleSet& rules, const world::GameState& state,
                                   world::Team team, const world::Vector2d& place);

/// Where a neutral start is made: as a free kick that would be fair for both, so `free_kick_area_distance`
/// from both areas (ours; the laws only ask for a legal point).
world::Vector2d neutral_position(const world::RuleSet& rules, const world::Vector2d& place);

/// Where play goes on after the ball left over a touch line.
world::Vector2d kick_in_position(const world::RuleSet& rules, const world::Vector2d& crossing);

/// Where play goes on after the ball left over a goal line: corner or goal kick.
///
/// Source  Algorithm 2, lines 27 to 33
world::Vector2d goal_line_position(const world::RuleSet& rules, const world::Vector2d& crossing, bool corner);

/// The penalty mark in front of the goal of `defending`.
world::Vector2d penalty_mark(const world::RuleSet& rules, const world::GameState& state,
                             world::Team defending);

}  // namespace automaton
