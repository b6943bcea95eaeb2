#pragma once

#include "sim/world/game_state.h"

namespace automaton {

/// The continuous variables until `time` (paper, Table 4): time runs everywhere; a team's time-out runs down
/// while it lasts, and the end of the half moves away with it, as while the game is halted (I-13, I-40);
/// yellow cards run down everywhere but in BREAK.
void continuous_update(world::GameState& state, world::Time time);

/// Moves every instant of the state by `by`, as if the whole match had been played that much later.
void move_in_time(world::GameState& state, world::Duration by);

}  // namespace automaton
