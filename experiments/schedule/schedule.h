#pragma once

#include <cstddef>
#include <optional>

#include "experiments/record/attempt.h"
#include "experiments/record/match_config.h"
#include "experiments/schedule/design.h"

namespace schedule {

/// One game of the schedule.
struct Game {
  record::GameKey key;
  world::Team a_colour = world::Team::Blue;
  record::MatchConfig config;  ///< without log and directory
};

/// Number of games in the whole schedule: two per pair and condition.
std::size_t game_count(const Design& design);

/// Game number `index`, computed from the number alone.
///
/// The order is pair by pair, in each pair condition by condition, in each condition leg by leg, so that a
/// schedule cut short has treated all conditions alike.
///
/// Seed   a hash of the design's seed, the pair and the leg, not of the condition, so that conditions share
///        their random numbers
/// Leg 0  A is blue
/// Leg 1  A is yellow
///
/// Two bits of the pair number say which end blue defends and who kicks off first, the same in both legs:
/// with all of it exchanged under one seed the second leg would be the first one with the names exchanged.
///
/// @pre index < game_count(design)
Game game(const Design& design, std::size_t index);

/// The game in that place; nothing when the design has no such condition, pair or leg.
std::optional<Game> game_of(const Design& design, const record::GameKey& key);

/// The game of that name.
///
/// @throws std::invalid_argument when the design has no such game, with an example of one
Game find_game(const Design& design, const std::string& id);

}  // namespace schedule
