#pragma once

#include <vector>

#include "experiments/record/match_record.h"
#include "experiments/runner/plan.h"

namespace runner {

/// A short game that shows, before a night begins, that two programs can play; it is played twice.
struct PreflightGame {
  Job job;
  std::vector<record::MatchRecord> records{};  ///< of the times it was played
};

/// One short game for every two programs that meet in the design.
std::vector<PreflightGame> preflight_games(const schedule::Design& design);

/// What a look at the records says.
struct PreflightFinding {
  bool failed = false;   ///< the night must not begin
  std::string sentence;  ///< what is wrong, or worth knowing; empty: nothing
};
PreflightFinding judged(const PreflightGame& game);

}  // namespace runner
