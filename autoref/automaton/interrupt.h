#pragma once

#include "autoref/automaton/automaton.h"

namespace automaton {

// Interruptions that are no part of the paper's tables: of the game by HALT (Table 1; the clock stops, I-40),
// of play by the operator's STOP.

/// Whether the game can be halted: it is on, and no break.
bool can_halt(const world::GameState& state);

/// Stops play where it is: a kick that was called stays called, running play goes on with a neutral start
/// from the ball [m], a penalty kick that was not decided is taken again. Sends nothing.
void interrupt(Automaton& automaton, const world::Vector2d& ball);

/// HALT: the game is interrupted, and clocks stand until `resume`.
/// @pre can_halt
void halt(Automaton& automaton, const world::Vector2d& ball);

/// STOP; the restart that was interrupted comes next.
/// @pre the state is halted
void resume(Automaton& automaton);

}  // namespace automaton
