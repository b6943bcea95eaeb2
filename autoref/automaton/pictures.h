#pragma once

#include <string>

#include "sim/world/rules/rule_set.h"

namespace automaton {

// What `scripts/draw_automaton.py` and `scripts/draw_positions.py` draw, as JSON.

/// The locations, and every row in table order: name, from, to, condition in words,
/// whether it sends a command.
std::string table_json();

/// The field, and for points of a grid over it (0.25 m apart, and a little beyond the lines) where the ball
/// goes for a free kick of yellow, of blue, and for a neutral start. Blue defends the goal at +x.
std::string positions_json(const world::RuleSet& rules);

}  // namespace automaton
