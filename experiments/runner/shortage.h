#pragma once

#include <chrono>
#include <exception>
#include <optional>
#include <string>

#include "experiments/record/match_record.h"

namespace runner {

/// Whether a worker could not be started since the machine has no process, memory or open file left for it, which
/// may pass by itself.
bool is_shortage(const std::exception& error);
/// Whether a void game says so: the worker began, and then its team or a file could not.
bool is_shortage(const record::MatchRecord& record);

/// Waits longer and longer before a game is started again when the machine lacks what a start needs: five void
/// games in a row take a tenth of a second, a shortage takes longer.
class Shortage {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param first     the first wait; each is twice the one before, up to a minute
  /// @param patience  how long a run waits for the first game that goes well again
  Shortage(std::chrono::milliseconds first, std::chrono::milliseconds patience)
      : first_(first), patience_(patience) {}

  /// A start failed. Those that failed together count once.
  ///
  /// @return  what is to be said; nothing when it was said already
  std::optional<std::string> failed(Clock::time_point now, const std::string& reason);

  /// A game ended that did not lack anything.
  void over() { since_.reset(); }

  bool lasts() const { return since_.has_value(); }
  /// No game should be started yet.
  bool waiting(Clock::time_point now) const { return since_ && now < until_; }
  /// Why the run has to end: it has lasted too long.
  std::optional<std::string> too_long(Clock::time_point now) const;

 private:
  std::chrono::milliseconds first_;
  std::chrono::milliseconds patience_;
  std::chrono::milliseconds wait_{};
  std::optional<Clock::time_point> since_;
  Clock::time_point until_{};
  std::string reason_;
};

}  // namespace runner
