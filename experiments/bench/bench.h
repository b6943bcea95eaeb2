#pragma once

#include <iosfwd>

#include "experiments/bench/figures.h"
#include "experiments/record/match_config.h"

namespace bench {

/// The standard game: 6 against 6, the reference team on both sides, 2 x 10 minutes, preset "measured",
/// seed 7.
record::MatchConfig standard_game();

/// What `matchday bench` may be told.
struct BenchOptions {
  record::MatchConfig game = standard_game();
  int cpu = 0;  ///< the processor for host and teams; -1: unbound, and the row "channel" means little
  bool as_json = false;  ///< JSON instead of the table
};

/// Plays the game once, with every part of every tick measured, and the reference scene before and after it.
/// @throws std::invalid_argument as host::play does, std::runtime_error when the game did not finish
Figures measure(const BenchOptions& options);

/// Backend of `matchday bench`: measures and prints. The caller turns exceptions into a sentence and exit
/// code 2.
/// @return exit code 0
int bench(const BenchOptions& options, std::ostream& out);

}  // namespace bench
