#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/process/child.h"
#include "experiments/record/attempt.h"
#include "experiments/runner/plan.h"
#include "experiments/schedule/limits.h"

namespace runner {

/// How long a worker may take before it is taken for stuck, and what it may use; all on the steady clock, so
/// that nobody setting the time can spoil a game.
struct WorkerLimits {
  std::chrono::milliseconds start_up{
      60'000};  ///< until the first simulated second; teams have 10 s to connect
  std::chrono::milliseconds silence{60'000};    ///< without simulated time going on; teams have 5 s to reply
  std::chrono::milliseconds game{3'600'000};    ///< for a whole game; usual are 6 to 30 s
  std::chrono::milliseconds grace{2'000};       ///< between TERM and KILL
  std::int64_t memory = std::int64_t{4} << 30;  ///< [bytes] of the worker itself, usual are 50 MB; ours
  std::size_t output = std::size_t{4} << 20;    ///< [bytes] kept of what the worker prints
};

/// The same as the design says it; the other two are not the design's.
WorkerLimits worker_limits(const schedule::Limits& limits,
                           std::chrono::milliseconds start_up = std::chrono::milliseconds{60'000},
                           std::chrono::milliseconds grace = std::chrono::milliseconds{2'000});

/// Where and what a worker plays.
struct Place {
  int slot = 0;                     ///< which of the runner's places, for the ledger
  int cpu = -1;                     ///< the only processor to run on
  std::filesystem::path folder{};   ///< for all its files; made anew
  std::filesystem::path scratch{};  ///< for temporary files, its own and the teams'; emptied afterwards
  std::string started{};            ///< date and time, for the ledger
};

/// What every process of a game has in its environment: this name, and the game's folder with a / at the end.
/// By it those are found that a game has left behind.
inline constexpr const char* game_variable = "MATCHDAY_GAME";

/// One game being played by a worker process of its own, bound to one processor.
///
/// A process per game: its start costs 10 ms of a game of 6 s, nothing can be left over from the game before,
/// and what is killed is exactly one game.
class Worker {
 public:
  /// Makes the game's folder anew and starts the worker in it.
  ///
  /// @param command  program and arguments, to which the job's and the result's file are appended
  /// @throws process::StartError or std::runtime_error when it cannot be started
  Worker(const std::vector<std::string>& command, const WorkerLimits& limits, Job job, Place place);

  /// The attempt, once the worker has ended or was ended for being stuck; never blocks for long.
  std::optional<record::Attempt> poll();

  /// Asks it to end; `stop` then waits and insists.
  void ask_to_end();
  void stop();

  const Job& job() const { return job_; }
  const Place& place() const { return place_; }
  pid_t pid() const { return child_.pid(); }
  double simulated() const { return simulated_; }  ///< [s] so far
  double seconds() const;                          ///< [s] since it was started
  /// Processes of the game that had to be looked for, since they had left every group.
  std::size_t strays() const { return strays_; }

 private:
  using Clock = std::chrono::steady_clock;

  std::optional<std::string> trouble(Clock::time_point now);
  record::MatchRecord result();
  record::MatchRecord fault(const std::string& reason) const;
  record::Attempt attempt(record::MatchRecord record);

  WorkerLimits limits_;
  Job job_;
  Place place_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_sign_ = start_;
  Clock::time_point memory_seen_ = start_;
  double simulated_ = 0;
  bool began_ = false;  ///< there was a sign of life
  std::size_t strays_ = 0;
  process::Child child_;
};

/// Why a worker could not be started, in words, and as the record of its game: void, the harness at fault.
std::string start_problem(const std::exception& error);
record::MatchRecord never_started(const std::exception& error);

/// Date and time now, UTC, as 2026-11-20T21:00:00Z. For people; nothing is decided by it.
std::string utc_now();

}  // namespace runner
