#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "experiments/runner/worker.h"
#include "experiments/schedule/design.h"

namespace runner {

struct RunOptions {
  std::filesystem::path out;                ///< the result folder
  int workers = 0;                          ///< games at a time; 0: one per processor we may use
  std::vector<std::string> worker_command;  ///< see job_files.h
  WorkerLimits limits;
  int most_faults_in_a_row =
      5;                 ///< void games, then the run stops: something is wrong with the machine (ours)
  std::string version;   ///< of matchday, for the manifest
  std::string protocol;  ///< of the channel between host and team
  std::vector<std::string> command_line;  ///< for the manifest and for the advice how to continue
  bool terminal = false;                  ///< whether `progress` is one
};

enum class Ending {
  Done,           ///< every game is in the ledger
  TooManyFaults,  ///< stopped, or some pairs were given up
  Interrupted     ///< by a signal
};

struct RunResult {
  Ending ending = Ending::Done;
  int signal = 0;             ///< that interrupted it
  std::filesystem::path out;  ///< the result folder
};

/// Plays what the ledger in the result folder still lacks of a design, on all processors.
///
/// The ledger is the only state: killed at any moment and started again, it ends in the same table. Games run
/// in worker processes that die with this one.
///
/// @throws std::invalid_argument when a team's program cannot be found
/// @throws record::StorageError when the result folder cannot be used or holds another experiment
RunResult run(const schedule::Design& design, const RunOptions& options, std::ostream& progress);

}  // namespace runner
