#include "autoref/automaton/interrupt.h"

#include "autoref/automaton/restart.h"

namespace automaton {

using world::CommandKind;
using world::GameState;
using world::Location;

bool can_halt(const GameState& state) {
  return state.location == Location::GameOn || state.location == Location::GameOff ||
         state.location == Location::Setup;
}

void interrupt(Automaton& automaton, const world::Vector2d& ball) {
  GameState& state = automaton.state();
  if (state.location != Location::GameOn) {
    same_restart_again(state);
  } else if (state.penalty) {
    next_penalty(automaton.rules(), state, state.kick_team);
  } else {
    next_neutral_start(automaton.rules(), state, ball);
  }
}

void halt(Automaton& automaton, const world::Vector2d& ball) {
  interrupt(automaton, ball);
  automaton.state().halted = true;
  automaton.send({CommandKind::Halt});
  automaton.enter(Location::Break);
}

void resume(Automaton& automaton) {
  automaton.state().halted = false;
  automaton.send({CommandKind::Stop});
  automaton.enter(Location::GameOff);
}

}  // namespace automaton
