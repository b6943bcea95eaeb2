#pragma once

#include "sim/world/game_state.h"

namespace automaton {

/// The continuous variables until `time` (paper, Table 4): time runs everywhere; a team's time-out runs down
/// while it lasts, and the end of the half moves away with it (I-13, I-40); yellow cards run down everywhere
/// but in BREAK.
void continuous_update(world::GameState& state, world::Time time);

}  // namespace automaton
