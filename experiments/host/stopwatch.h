#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace host {

/// The parts of a tick that are measured, in the order in which they happen (DESIGN, "Cost of one tick").
enum class Part : std::uint8_t { Physics, Vision, Bookkeeping, Referee, Log, Messages, Channel };
inline constexpr std::size_t part_count = 7;
const char* name(Part part);

/// Wall time of each part of each tick.
///
/// Channel is the time from the first byte written to the last one read: with everything on one processor it
/// contains the work of both teams, which is subtracted afterwards from their own processor time.
class Stopwatch {
 public:
  using Clock = std::chrono::steady_clock;

  void begin_tick() {
    ticks_.push_back({});
    last_ = Clock::now();
  }
  /// Books the time since the last call under `part`.
  void lap(Part part) {
    const Clock::time_point now = Clock::now();
    add(part, now - last_);
    last_ = now;
  }
  /// Books `taken` of the time since the last call under `part`, the rest stays for the next lap().
  void part_of_lap(Part part, Clock::duration taken) {
    add(part, taken);
    last_ += taken;
  }

  std::size_t ticks() const { return ticks_.size(); }
  /// The times of a part in all ticks [s].
  std::vector<double> times(Part part) const;
  double mean(Part part) const;  ///< [s]

  std::int64_t messages = 0;  ///< both ways
  std::int64_t bytes_out = 0;
  std::int64_t bytes_in = 0;
  std::int64_t channel_calls = 0;  ///< of the system, by the host
  double loop_seconds = 0;         ///< wall, of the tick loop alone

 private:
  void add(Part part, Clock::duration taken) {
    ticks_.back()[static_cast<std::size_t>(part)] += std::chrono::duration<float>(taken).count();
  }

  std::vector<std::array<float, part_count>> ticks_;  // [s]
  Clock::time_point last_;
};

}  // namespace host
