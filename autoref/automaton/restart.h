#pragma once

#include "sim/world/game_state.h"
#include "sim/world/rules/rule_set.h"

namespace automaton {

/// What every stoppage leaves behind (I-5, I-11, I-38): the kick that comes next, whose it is, and from where
/// [m]. A penalty that was not decided yet is none any more.
void next_restart(world::GameState& state, world::CommandKind kind, world::Team team,
                  const world::Vector2d& position);

/// A neutral start from the legal point nearest to the ball [m]; in a shoot-out, where there is none, the
/// present penalty kick once more.
void next_neutral_start(const world::RuleSet& rules, world::GameState& state, const world::Vector2d& ball);

/// A penalty kick for `team`, from the mark.
void next_penalty(const world::RuleSet& rules, world::GameState& state, world::Team team);

/// The restart that had been called, once more; its place stays.
void same_restart_again(world::GameState& state);

/// The present attempt of a shoot-out is over, and the other team's comes next.
void next_shootout_kick(const world::RuleSet& rules, world::GameState& state, bool scored);

}  // namespace automaton
