#pragma once

#include <cstdint>
#include <optional>

#include "sim/world/time.h"

namespace wire {

/// What the wire calls zero match time: instants on the wire are Unix time = epoch + match time.
///
/// The default, 1 700 000 000 s, is ours: a plausible Unix time that is the same in every game.
struct Epoch {
  std::int64_t nanoseconds = 1'700'000'000'000'000'000;  ///< [ns, Unix] of match time zero
};

/// Instant on the wire [us, Unix], to the nearest microsecond.
std::int64_t to_microseconds(world::Time time, Epoch epoch);
/// Match time of an instant on the wire [us, Unix]. Inverse of `to_microseconds` for whole microseconds.
/// @pre  |microseconds| < 4e15, the year 2096
world::Time from_microseconds(std::int64_t microseconds, Epoch epoch);

/// Instant on the wire [s, Unix]: the double nearest to the whole number of microseconds.
///
/// A double resolves 0.24 us at today's Unix times, so each microsecond has a double of its own until 2112.
double to_unix_seconds(world::Time time, Epoch epoch);
/// Match time of an instant on the wire [s, Unix], to the nearest microsecond; nothing when it is not finite
/// or lies outside the years 1970 to 2096.
std::optional<world::Time> from_unix_seconds(double unix_seconds, Epoch epoch);

}  // namespace wire
