#pragma once

#include <optional>

#include "sim/world/time.h"

namespace world {

/// One value of a guard function: negative before its event, zero or more after it.
struct GuardSample {
  Time time;
  double value = 0;
};

/// Returns when the guard rose through zero between two samples, or nothing.
///
/// Fires only if `before.value < 0 <= after.value`, so a touch at a shared end point counts once.
/// The instant is found by linear interpolation: exact for a guard that is linear in time,
/// otherwise wrong by at most one frame.
///
/// @pre `before.time < after.time`, both values finite.
std::optional<Time> rising_zero(const GuardSample& before, const GuardSample& after);

}  // namespace world
