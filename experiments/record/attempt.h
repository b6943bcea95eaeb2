#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "experiments/record/match_record.h"

namespace record {

/// Where a game stands in the schedule of its experiment.
struct GameKey {
  std::string condition;
  int pair = 0;
  int leg = 0;  ///< 0: team A is blue, 1: team A is yellow
  auto operator<=>(const GameKey&) const = default;
};

/// The name of a game in the ledger, on the command line and in paths: "equal-0003-1".
std::string game_id(const GameKey& key);

/// One try at one game, as the ledger keeps it. Harness faults are tried again, so a game may have several.
struct Attempt {
  GameKey key;
  int attempt = 1;
  std::uint64_t seed = 0;
  world::Team a_colour = world::Team::Blue;
  bool blue_on_positive_half = true;
  world::Team first_kickoff = world::Team::Yellow;
  MatchRecord record;
  std::string started;  ///< date and time when it began, UTC; not part of the result
  int worker = 0;       ///< which worker played it; not part of the result
  bool operator==(const Attempt&) const = default;
};

inline constexpr int max_attempts = 3;  ///< of a pair, before it is given up (DESIGN, "Outcomes")

/// How far one pair of one condition has come.
///
/// A void game takes its partner with it: the tables need both legs of a pair from the same attempt, and a
/// leg dropped alone would be dropped for a reason that has to do with its result.
struct PairState {
  int attempt = 1;                       ///< the attempt that counts, or would be the next
  std::array<const Attempt*, 2> legs{};  ///< played in that attempt; null: not yet
  int voids = 0;                         ///< void games of all attempts
  bool given_up = false;                 ///< every attempt had a void game
  bool complete() const { return !given_up && legs[0] != nullptr && legs[1] != nullptr; }
};

/// The state of a pair from all that the ledger holds of that pair, in any order.
PairState pair_state(std::span<const Attempt* const> attempts);

}  // namespace record
