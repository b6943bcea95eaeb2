#pragma once

#include "autoref/automaton/automaton.h"
#include "autoref/referee/call.h"
#include "sim/world/rules/rule_set.h"

namespace referee {

/// Whether anyone on the field notices the transition: it sends a command, stops play or shows a card.
bool is_call(const automaton::Transition& transition);

/// An offence without consequence, as a call of row "note"; nothing for anything else.
std::optional<Call> note(const automaton::Occurrence& occurrence, const world::GameState& state);

/// The transition as a call, with its sentence.
Call explain(const automaton::Transition& transition, const world::RuleSet& rules);

/// One plain sentence about an event that was detected, without a decision: for watching.
std::string describe(const world::GameEvent& event);

/// Its name, such as "ball touched".
std::string kind_of(const world::GameEvent& event);

/// "indirect free kick"
std::string kick_name(world::CommandKind kind);

/// "yellow 4"
std::string text(world::RobotId robot);
/// "(1.20, -2.90) m"
std::string text(const world::Vector2d& place);

}  // namespace referee
