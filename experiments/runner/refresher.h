#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/process/child.h"

namespace runner {

/// Runs a command now and then that makes something of the result folder, as its report.
///
/// In a process of its own: whatever goes wrong there does not end a night, and its memory is gone after it.
class Refresher {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param command  empty: nothing is ever run
  /// @param log      file for what it prints, kept when it fails
  Refresher(std::vector<std::string> command, std::chrono::milliseconds interval, std::filesystem::path log);

  /// Starts it when it is time, notices when it has ended.
  ///
  /// @return  a complaint, the first time it fails
  std::optional<std::string> look(Clock::time_point now = Clock::now());

  /// Runs it once more, to its end.
  ///
  /// @param enough  asked while it runs: whether nobody waits for it any more; then it is ended
  std::optional<std::string> last(const std::function<bool()>& enough = {});

  /// -1: it is not running.
  pid_t pid() const { return child_ ? child_->pid() : -1; }

 private:
  void start();
  bool wait(const std::function<bool()>& enough);
  std::optional<std::string> ended();

  std::vector<std::string> command_;
  std::chrono::milliseconds interval_;
  Clock::duration pause_;  ///< from the last start to the next: longer than the interval when it takes long
  std::filesystem::path log_;
  std::optional<process::Child> child_;
  std::optional<std::string> problem_;  ///< that it could not be started
  Clock::time_point started_;
  bool complained_ = false;
};

}  // namespace runner
