#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/disk.h"
#include "experiments/runner/worker.h"
#include "experiments/schedule/design.h"

namespace runner {

struct RunOptions {
  std::filesystem::path out;                ///< the result folder
  int workers = 0;                          ///< games at a time; 0: one per processor we may use
  std::vector<std::string> worker_command;  ///< see job_files.h
  schedule::Limits limits;
  bool preflight = true;                  ///< a short game, played twice, before the first of a folder
  bool record = true;                     ///< keep the teams' replies of faulty and sampled games
  std::string version;                    ///< of matchday, for the manifest
  std::string protocol;                   ///< of the channel between host and team
  std::string isolation;                  ///< what the teams get, in words, for the manifest
  std::vector<std::string> command_line;  ///< for the manifest and for the advice how to continue
  /// A folder that holds the same experiment with this many pairs goes on with the design's; nothing: it is
  /// another experiment.
  std::optional<int> grown_from{};
  bool terminal = false;  ///< whether `progress` is one

  /// A command that renews the report in the result folder, now and then and at the end; empty: none.
  std::vector<std::string> refresh_command;
  std::chrono::milliseconds refresh_interval{60'000};

  // Seldom changed; tests do.
  std::chrono::milliseconds start_up{60'000};     ///< of a worker until it plays
  std::chrono::milliseconds first_pause{1'000};   ///< before a start that failed for lack of processes
  std::chrono::milliseconds grace{2'000};         ///< between TERM and KILL
  std::chrono::milliseconds housekeeping{1'000};  ///< between two looks at disk, orphans, status
  std::chrono::milliseconds disk_patience{15 *
                                          60'000};  ///< for room on a full disk, or a ledger held by others
  std::function<bool(const std::filesystem::path&)> is_remote = runner::is_remote;  ///< the file system
  std::function<std::int64_t(const std::filesystem::path&)> free_bytes = runner::free_bytes;
  std::function<std::string()> date = utc_now;  ///< for people; nothing is decided by it
};

enum class Ending {
  Done,             ///< every game is in the ledger
  PreflightFailed,  ///< the teams cannot play; nothing is in the ledger
  TooManyFaults,    ///< stopped, or some pairs were given up
  Interrupted       ///< by a signal
};

struct RunResult {
  Ending ending = Ending::Done;
  int signal = 0;             ///< that interrupted it
  std::filesystem::path out;  ///< the result folder
};

/// Plays what the ledger in the result folder still lacks of a design, on all processors.
///
/// The ledger is the only state: killed at any moment and started again, it ends in the same table. Games run
/// in worker processes that die with this one. The first SIGINT, SIGTERM or SIGHUP lets the running games
/// finish, the second ends them. While it runs, status.json in the result folder says how it stands.
///
/// @throws std::invalid_argument when a team's program cannot be found
/// @throws record::StorageError when the result folder cannot be used or holds another experiment,
///         when the disk is full, or when a program of the experiment is changed meanwhile;
///         nothing is lost but running games
RunResult run(const schedule::Design& design, const RunOptions& options, std::ostream& progress);

}  // namespace runner
