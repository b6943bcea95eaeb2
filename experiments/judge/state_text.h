#pragma once

#include <string>

#include "sim/world/game_state.h"

namespace judge {

/// What detectors may ask of a game state, as one line of JSON; its running clocks are left out.
std::string state_text(const world::GameState& state);

/// The same read back.
/// @throws std::exception, whatever reading JSON throws, or std::invalid_argument
world::GameState state_in(const std::string& text);

}  // namespace judge
