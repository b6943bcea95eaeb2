#pragma once

#include <optional>

#include "sim/world/game_state.h"
#include "sim/world/rules/rule_set.h"

namespace automaton {

// The paper's functions of a stage (6.2, Table 5), and the stages of a game that needs a winner (laws of
// 2015, appendix A).

/// A half that is being played: FIRST, SECOND and those of extra time.
bool is_half(world::Stage stage);
/// PRE-FIRST and its like: the kickoff of a half is due.
bool is_before_half(world::Stage stage);
/// HALFTIME and its like, after which a half begins.
bool is_half_time(world::Stage stage);

/// next-stage(s). A draw after SECOND goes to extra time, and one after EXTRA-SECOND to a shoot-out, when the
/// rules want a winner.
world::Stage next_stage(const world::RuleSet& rules, world::Stage stage, bool draw);

/// stage-length(s); nothing where a stage ends by what happens (PRE stages, shoot-out, POST).
std::optional<world::Duration> stage_length(const world::RuleSet& rules, world::Stage stage);

/// Whose kickoff opens the half that the stage belongs to: the first half and the first of extra time are
/// `first_kickoff`'s, the others its opponent's (Law 8).
world::Team kickoff_team(const world::GameState& state, world::Stage stage);

/// stage-end-cmd(s): HALT for a half, KICKOFF(T) for a half-time, STOP for the break before a shoot-out.
world::Command stage_end_command(const world::GameState& state);

/// How often ends were changed before the stage: with every half, not before the shoot-out.
int ends_changed(world::Stage stage);

/// Whether a shoot-out is decided: one team leads by more than the other can still score, or after equally
/// many kicks, at least `shootout_kicks` each (appendix A).
bool shootout_is_decided(const world::RuleSet& rules, const world::GameState& state);

/// Whether it ends: decided, or after `shootout_limit` kicks each.
bool shootout_is_over(const world::RuleSet& rules, const world::GameState& state);

}  // namespace automaton
