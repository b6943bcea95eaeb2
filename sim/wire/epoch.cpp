#include "sim/wire/epoch.h"

#include <cassert>
#include <chrono>
#include <cmath>

namespace wire {

namespace {

constexpr double last_second = 4e9;  // ours: the year 2096; doubles resolve microseconds beyond it

}  // namespace

std::int64_t to_microseconds(world::Time time, Epoch epoch) {
  const std::chrono::nanoseconds unix_time =
      time.time_since_epoch() + std::chrono::nanoseconds{epoch.nanoseconds};
  return std::chrono::round<std::chrono::microseconds>(unix_time).count();
}

world::Time from_microseconds(std::int64_t microseconds, Epoch epoch) {
  assert(std::abs(microseconds) <= static_cast<std::int64_t>(last_second) * 1'000'000);
  return world::Time{std::chrono::microseconds{microseconds} - std::chrono::nanoseconds{epoch.nanoseconds}};
}

double to_unix_seconds(world::Time time, Epoch epoch) {
  return static_cast<double>(to_microseconds(time, epoch)) /
         1e6;  // both exact, so the quotient is the nearest double
}

std::optional<world::Time> from_unix_seconds(double unix_seconds, Epoch epoch) {
  if (!(unix_seconds >= 0 && unix_seconds <= last_second)) return std::nullopt;  // also NaN
  return from_microseconds(std::llround(unix_seconds * 1e6), epoch);
}

}  // namespace wire
