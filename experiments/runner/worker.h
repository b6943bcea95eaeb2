#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/process/child.h"
#include "experiments/record/attempt.h"
#include "experiments/runner/plan.h"

namespace runner {

/// How long a worker may take before it is taken for stuck; wall time.
struct WorkerLimits {
  std::chrono::milliseconds silence{
      60'000};  ///< without a sign of life; teams have 10 s to connect and 5 s to reply
  std::chrono::milliseconds game{3'600'000};  ///< for a whole game; usual are 15 to 30 s
  std::chrono::milliseconds grace{2'000};     ///< between TERM and KILL
};

/// One game being played by a worker process of its own, bound to one processor.
///
/// A process per game: its start costs 10 ms of a game of 15 s, nothing can be left over from the game
/// before, and what is killed is exactly one game.
class Worker {
 public:
  /// Makes the game's folder anew and starts the worker in it.
  ///
  /// @param command  program and arguments, to which the job's and the result's file are appended
  /// @throws process::StartError or std::runtime_error when it cannot be started
  Worker(const std::vector<std::string>& command, const WorkerLimits& limits, int slot, int cpu, Job job,
         const std::filesystem::path& folder);

  /// The attempt, once the worker has ended or was ended for being stuck; never blocks for long.
  std::optional<record::Attempt> poll();

  /// Asks it to end; `stop` then waits and insists.
  void ask_to_end();
  void stop();

  int slot() const { return slot_; }

 private:
  using Clock = std::chrono::steady_clock;

  record::MatchRecord result();
  record::MatchRecord fault(const std::string& reason) const;
  record::Attempt attempt(record::MatchRecord record) const;

  WorkerLimits limits_;
  int slot_;
  Job job_;
  std::filesystem::path folder_;
  std::string started_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_sign_ = Clock::now();
  std::size_t printed_ = 0;  ///< [bytes] so far
  process::Child child_;
};

/// Date and time now, UTC, as 2026-11-20T21:00:00Z.
std::string utc_now();

}  // namespace runner
