#pragma once

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "experiments/record/ledger.h"

namespace runner {

/// Writes into a ledger what a run finds out, in its order, also when another program holds the ledger or its
/// disk is full: then it is kept in memory and written later. While it waits no game should be started, so
/// that there is never more of it than there are places for games.
class LedgerWriter {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param patience  how long a run waits for the ledger
  LedgerWriter(record::Ledger& ledger, std::chrono::milliseconds patience)
      : ledger_(ledger), patience_(patience) {}

  /// @param what  is to be written; called again when it was blocked
  /// @param then  called once it is on the disk
  /// @throws record::StorageError when it can never be written
  void write(std::function<void(record::Ledger&)> what, std::function<void()> then = {});

  enum class News {
    None,
    Blocked,  ///< since now
    Free,     ///< again, and everything is written
    GiveUp,   ///< blocked for longer than a run waits, see `idle`
  };
  /// Tries again what is waiting.
  /// @param idle  whether no game is running: only then the waiting may end
  News look(Clock::time_point now, bool idle);

  std::size_t waiting() const { return queue_.size(); }    ///< things that are not written yet
  const std::string& sentence() const { return reason_; }  ///< why

 private:
  struct Entry {
    std::function<void(record::Ledger&)> what;
    std::function<void()> then;
  };
  void flush();

  record::Ledger& ledger_;
  std::chrono::milliseconds patience_;
  std::deque<Entry> queue_;
  std::string reason_;
  std::optional<Clock::time_point> since_;  ///< it has been blocked, as far as it was told
};

}  // namespace runner
