#pragma once

#include <iosfwd>
#include <string>

#include "experiments/bench/figures.h"
#include "experiments/process/isolation.h"
#include "experiments/record/match_config.h"

namespace bench {

/// The standard game: 6 against 6, the reference team on both sides, 2 x 10 minutes,
/// preset "measured", seed 7.
record::MatchConfig standard_game();

/// What `matchday bench` may be told.
struct BenchOptions {
  record::MatchConfig game = standard_game();
  int cpu = 0;       ///< the processor for host and teams; -1: unbound, and the row "channel" means little
  int workers = -1;  ///< games at once, for the games per hour; 0: not measured, -1: one per processor
  /// Teams are told `--timing on` while the game is measured, for median and 99 % of their ticks; false for
  /// teams that do not know it.
  bool team_times = true;
  process::Isolation isolation = process::Isolation::None;  ///< of the teams; costs a start, not a tick
  bool as_json = false;                                     ///< JSON instead of the table
  std::string compare{};  ///< file of older figures to be compared with; empty: none
};

/// Plays the game once, with every part of every tick measured, and the reference scene before and after it.
/// @throws std::invalid_argument as host::play does, std::runtime_error when the game did not finish
Figures measure(const BenchOptions& options);

/// Backend of `matchday bench`: measures and prints; what is wrong with the file to be compared with is
/// said before anything is measured. The caller turns exceptions into a sentence and exit code 2.
/// @return exit code 0
int bench(const BenchOptions& options, std::ostream& out);

}  // namespace bench
