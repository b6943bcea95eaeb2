#pragma once

#include <chrono>
#include <cstdint>

namespace world {

/// Match time: zero when the match is created, never the wall clock.
struct MatchClock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<MatchClock>;
};
using Time = MatchClock::time_point;
using Duration = MatchClock::duration;

inline constexpr int ticks_per_second = 60;  ///< the cameras' rate (paper, 3.1)
inline constexpr int substeps_per_tick = 4;  ///< physics steps of 1/240 s; coarser lets fast balls tunnel
inline constexpr double tick_length = 1.0 / ticks_per_second;              ///< [s]
inline constexpr double substep_length = tick_length / substeps_per_tick;  ///< [s]

/// Instant of substep `substep` (0..4) after the start of tick `tick`, to the nearest nanosecond.
///
/// Computed from the numbers, never accumulated, so that it does not drift.
constexpr Time tick_time(std::int64_t tick, int substep = 0) {
  const std::int64_t numerator = (tick * substeps_per_tick + substep) * 1'000'000'000;
  constexpr std::int64_t denominator = ticks_per_second * substeps_per_tick;
  return Time{Duration{(2 * numerator + denominator) / (2 * denominator)}};
}

constexpr double seconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }
/// Seconds since the match was created.
constexpr double seconds(Time time) { return seconds(time.time_since_epoch()); }

/// The nearest nanosecond to a number of seconds.
constexpr Duration from_seconds(double value) {
  return Duration{static_cast<std::int64_t>(value * 1e9 + (value < 0 ? -0.5 : 0.5))};
}

/// Rounds to the wire's resolution, so that the embedded referee and a log see the same instants.
constexpr Time whole_microseconds(Time time) {
  return Time{std::chrono::round<std::chrono::microseconds>(time.time_since_epoch())};
}

}  // namespace world
