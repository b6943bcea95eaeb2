#include "autoref/automaton/clock.h"

namespace automaton {

void continuous_update(world::GameState& state, world::Time time) {
  const world::Duration passed = time - state.time;
  state.time = time;
  if (state.location == world::Location::Init) return;  // the match had not begun
  if (state.location == world::Location::Break) {
    if (!state.timeout_team && !state.halted) return;
    if (state.timeout_team) state.timeout_time[*state.timeout_team] -= passed;
    if (state.stage_end) *state.stage_end += passed;
    return;
  }
  for (const world::Team team : world::both_teams) {
    for (world::Duration& left : state.yellow_times[team]) left -= passed;
  }
}

void move_in_time(world::GameState& state, world::Duration by) {
  state.time += by;
  state.command_time += by;
  state.location_time += by;
  if (state.stage_end) *state.stage_end += by;
  if (state.kick_deadline) *state.kick_deadline += by;
  if (state.last_touch) state.last_touch->time += by;
  if (state.penalty) state.penalty->taken += by;
}

}  // namespace automaton
