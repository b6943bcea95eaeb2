#pragma once

#include <chrono>
#include <csignal>
#include <optional>

namespace runner {

/// Ctrl-C and a polite request to end, as values instead of interruptions, for the life of this object.
///
/// SIGINT, SIGTERM and SIGHUP are held back and read through a signalfd, so nothing has to be done inside a
/// signal handler. SIGPIPE and SIGXFSZ are ignored meanwhile: that nobody reads what we print any more, or
/// that a file may not grow, is an error of that write and no reason to die.
class Signals {
 public:
  Signals();
  Signals(const Signals&) = delete;
  Signals& operator=(const Signals&) = delete;
  ~Signals();

  /// Sleeps until a signal comes; nothing when `patience` has passed without one.
  std::optional<int> wait(std::chrono::milliseconds patience);

 private:
  sigset_t before_{};
  struct sigaction pipe_before_ {};
  struct sigaction size_before_ {};
  int fd_ = -1;
};

}  // namespace runner
