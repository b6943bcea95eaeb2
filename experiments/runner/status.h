#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/runner/time_left.h"

namespace runner {

/// How a run stands, for programs that watch it: the content of status.json.
struct Status {
  struct Game {
    std::string game;
    int attempt = 1;
    std::string kind;      ///< "game", "audit" or "preflight"
    double simulated = 0;  ///< [s] so far
    double seconds = 0;    ///< [s] since it began
  };

  std::string experiment;
  std::string state;  ///< preflight, running, draining, waiting-for-disk, waiting-for-ledger, or how it ended
  std::string reason;            ///< why it waits or has ended; empty while all is well
  int process = 0;               ///< number of the runner
  std::string started, updated;  ///< UTC
  double seconds = 0;            ///< [s] since the start

  std::size_t games = 0;     ///< in the schedule
  std::size_t resolved = 0;  ///< that need not be played again
  std::size_t played = 0;    ///< attempts that ended in this run
  std::size_t voids = 0;     ///< of all runs, and so on
  std::size_t forfeits = 0;
  std::size_t given_up_pairs = 0;
  std::size_t distinct = 0;  ///< hashes among the finished games
  std::size_t audited = 0;
  std::size_t audits_that_differ = 0;
  std::size_t strays = 0;  ///< processes that games left behind, ended

  std::optional<TimeLeft::Estimate> left;
  std::int64_t memory = 0;      ///< [bytes] the runner holds
  std::size_t open_files = 0;   ///< of the runner
  std::int64_t free_disk = 0;   ///< [bytes]
  std::int64_t kept_files = 0;  ///< [bytes] of kept games
  std::vector<Game> running;
};

std::string to_json(const Status& status);

/// Replaces the file as a whole; that it cannot be written is no reason to end a run.
void write_status(const std::filesystem::path& file, const Status& status);

/// Files this process has open.
std::size_t open_files();

}  // namespace runner
