#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace runner {

/// Room on the disk of a result folder: on a full one no game is started, and running ones may end. Room may
/// come back by itself.
class DiskWatch {
 public:
  using Clock = std::chrono::steady_clock;

  /// @param needed      [bytes] that must be free
  /// @param free_bytes  says how many are
  /// @param patience    how long a run waits for room
  DiskWatch(std::filesystem::path folder, std::int64_t needed,
            std::function<std::int64_t(const std::filesystem::path&)> free_bytes,
            std::chrono::milliseconds patience);

  enum class News {
    None,
    Full,    ///< since now
    Room,    ///< again
    GiveUp,  ///< full for longer than a run waits, see `idle`
  };
  /// Looks at the disk.
  /// @param idle  whether no game is running: only then the waiting may end
  News look(Clock::time_point now, bool idle);

  bool waiting() const { return waiting_.has_value(); }  ///< for room
  std::int64_t free() const { return free_; }            ///< [bytes] at the last look
  std::string sentence() const;                          ///< how much there is, and how much is needed

 private:
  std::filesystem::path folder_;
  std::int64_t needed_;
  std::function<std::int64_t(const std::filesystem::path&)> free_bytes_;
  std::chrono::milliseconds patience_;
  std::int64_t free_ = 0;
  std::optional<Clock::time_point> waiting_;  ///< since when
};

std::string mebibytes(std::int64_t bytes);  ///< "1024 MiB"

}  // namespace runner
