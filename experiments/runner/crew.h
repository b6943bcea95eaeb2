#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "experiments/runner/scratch.h"
#include "experiments/runner/status.h"
#include "experiments/runner/worker.h"

namespace runner {

/// What a game is played for.
enum class Purpose { Schedule, Audit, Preflight };

const char* name(Purpose purpose);  ///< "game", "audit", "preflight"

/// The places for games on this machine, one per processor, and the workers playing in them.
class Crew {
 public:
  struct Ended {
    std::size_t slot = 0;
    Purpose purpose{};
    record::Attempt attempt;
    double seconds = 0;      ///< wall
    std::size_t strays = 0;  ///< processes it had left behind
  };

  /// @param places  0: one per processor we may use
  /// @throws record::StorageError when there can be no temporary files
  Crew(std::vector<std::string> command, const WorkerLimits& limits, int places,
       const std::filesystem::path& scratch_note);

  std::size_t places() const { return slots_.size(); }
  std::size_t running() const;
  bool has_room() const { return running() < places(); }

  /// Starts a game in a free place and returns its number.
  ///
  /// @pre has_room()
  /// @throws process::StartError or std::runtime_error when the worker cannot be started
  std::size_t start(Purpose purpose, Job job, const std::filesystem::path& folder, const std::string& date);

  /// The games that have ended since.
  std::vector<Ended> collect();

  /// Ends all that are running.
  void end();

  std::vector<pid_t> pids() const;
  std::vector<Status::Game> games() const;

 private:
  struct Slot {
    std::unique_ptr<Worker> worker;  ///< null: free
    Purpose purpose{};
  };

  std::vector<std::string> command_;
  WorkerLimits limits_;
  Scratch scratch_;
  std::vector<int> cpus_;
  std::vector<Slot> slots_;
};

}  // namespace runner
