#pragma once

#include <functional>
#include <optional>
#include <string>

#include "experiments/runner/disk_watch.h"
#include "experiments/runner/ledger_writer.h"

namespace runner {

/// What a run needs to write: room on the disk, and a ledger that no other program holds. While one is
/// missing no game is started; either may come back by itself.
class Storage {
 public:
  Storage(LedgerWriter& writer, DiskWatch disk) : writer_(writer), disk_(std::move(disk)) {}

  /// Before the first game nothing is waited for; a sentence: the run must not begin.
  std::optional<std::string> look_first();

  /// Looks at both.
  ///
  /// @param idle  whether no game is running: only then the waiting may end
  /// @param say   is called with news
  /// @return      why the run has to end
  std::optional<std::string> look(DiskWatch::Clock::time_point now, bool idle,
                                  const std::function<void(const std::string&)>& say);

  /// At the end: what could not be written although it was tried once more.
  std::optional<std::string> lost();

  bool waiting() const { return disk_.waiting() || writer_.waiting() > 0; }
  const char* state() const { return disk_.waiting() ? "waiting-for-disk" : "waiting-for-ledger"; }
  std::int64_t free() const { return disk_.free(); }  ///< [bytes] of the disk, at the last look

 private:
  LedgerWriter& writer_;
  DiskWatch disk_;
};

}  // namespace runner
