#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/match_record.h"
#include "experiments/runner/crew.h"
#include "experiments/runner/plan.h"
#include "experiments/runner/result_folder.h"

namespace runner {

/// A short game that shows, before a night begins, that two programs can play; it is played twice.
struct PreflightGame {
  Job job;
  std::vector<record::MatchRecord> records{};  ///< of the times it was played
  int games = 0;                               ///< of the design that these two play
};

/// One short game for every two programs that meet in the design.
std::vector<PreflightGame> preflight_games(const schedule::Design& design);

/// Plays each of them twice and fills in their records.
///
/// @param look  called every 20 ms or so; the number of a signal ends the crew
/// @return      that number
std::optional<int> play_preflight(std::vector<PreflightGame>& games, Crew& crew, const ResultFolder& folder,
                                  const std::function<std::string()>& date,
                                  const std::function<std::optional<int>()>& look);

/// What a look at the records says.
struct PreflightFinding {
  bool failed = false;   ///< the night must not begin
  std::string sentence;  ///< what is wrong, or worth knowing; empty: nothing
};
PreflightFinding judged(const PreflightGame& game, const schedule::Design& design);

/// The same of all, with what they say about the night's length.
struct PreflightVerdict {
  std::string failure;               ///< why the night must not begin; empty: it may
  std::vector<std::string> remarks;  ///< worth knowing
};
/// @param places  games at a time
PreflightVerdict verdict(const std::vector<PreflightGame>& games, const schedule::Design& design,
                         std::size_t places);

}  // namespace runner
