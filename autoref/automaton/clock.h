#pragma once

#include "sim/world/game_state.h"

namespace automaton {

/// The continuous variables until `time` (paper, Table 4):
/// - Time runs everywhere.
/// - A team's time-out runs down while it lasts, and the end of the half is put off by as much, as it is
///   while the game is halted (I-13, I-40).
/// - Yellow cards run down everywhere but in BREAK.
void continuous_update(world::GameState& state, world::Time time);

/// Moves every instant of the state by `by`, as if the whole match had been played that much later.
void move_in_time(world::GameState& state, world::Duration by);

}  // namespace automaton
