#include "autoref/automaton/restart.h"

#include "autoref/automaton/positions.h"

namespace automaton {

using world::CommandKind;
using world::GameState;
using world::Team;
using world::Vector2d;

void next_restart(GameState& state, CommandKind kind, Team team, const Vector2d& position) {
  state.call = kind;
  state.restart = kind;
  state.kick_team = team;
  state.reset_position = position;
  state.is_kickoff = kind == CommandKind::Kickoff;
  state.penalty.reset();
}

void next_neutral_start(const world::RuleSet& rules, GameState& state, const Vector2d& ball) {
  if (state.stage == world::Stage::Shootout) {
    next_penalty(rules, state, state.kick_team);
  } else {
    next_restart(state, CommandKind::Start, state.kick_team, neutral_position(rules, ball));
  }
}

void next_penalty(const world::RuleSet& rules, GameState& state, Team team) {
  next_restart(state, CommandKind::Penalty, team, penalty_mark(rules, state, world::opponent(team)));
}

void same_restart_again(GameState& state) {
  state.call = state.restart;
  state.is_kickoff = state.restart == CommandKind::Kickoff;
}

void next_shootout_kick(const world::RuleSet& rules, GameState& state, bool scored) {
  ++state.shootout_kicks[state.kick_team];
  if (scored) {
    ++state.shootout_goals[state.kick_team];
    ++state.score[state.kick_team];
  }
  next_penalty(rules, state, world::opponent(state.kick_team));
}

}  // namespace automaton
