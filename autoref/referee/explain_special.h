#pragma once

#include <optional>
#include <string>

#include "autoref/automaton/automaton.h"

namespace referee {

/// What happened, for the rows that the paper lacks: penalty kicks (R15-15), extra time and shoot-out (R8-10,
/// T16.a, T17.a), cards while play is stopped (I-9); nothing for all others.
std::optional<std::string> special_sentence(const automaton::Transition& transition,
                                            const world::RuleSet& rules);

/// ", yellow card for blue", or nothing when none was shown.
std::string card_text(const automaton::Transition& transition);

}  // namespace referee
