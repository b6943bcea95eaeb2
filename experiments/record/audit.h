#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "experiments/record/attempt.h"

namespace record {

/// What came out when a game of the ledger was played again.
enum class Verdict : std::uint8_t {
  Same,  ///< the same hash
  /// another hash with live teams, the same from their recorded replies: a team is not deterministic;
  /// no fault, but worth knowing
  TeamDiffers,
  SimulatorDiffers,  ///< another hash from the same replies: a mistake of ours
  TeamsOrUsDiffer,   ///< another hash with live teams, and there were no recorded replies to tell more
  Failed             ///< it could not be played again
};

const char* name(Verdict verdict);  ///< "same", "team-differs", ...
/// @throws std::invalid_argument naming the word and the known ones
Verdict verdict_from_name(std::string_view word);

/// One game of the ledger, played again to compare the hashes.
struct Audit {
  GameKey key;
  int attempt = 1;
  Verdict verdict = Verdict::Failed;
  std::string hash;    ///< of the game played again with live teams
  std::string reason;  ///< why it failed; empty otherwise
  bool operator==(const Audit&) const = default;
};

}  // namespace record
