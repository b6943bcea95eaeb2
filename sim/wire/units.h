#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "sim/world/geometry.h"
#include "sim/world/time.h"

// The league's units, for sim/wire's own sources only.
namespace wire {

/// The same operations as `world::as_on_wire`, split at the wire.
inline float to_mm(double metres) { return static_cast<float>(metres * 1000.0); }
inline double from_mm(float mm) { return static_cast<double>(mm) / 1000.0; }

inline std::int32_t to_whole_mm(double metres) {
  return static_cast<std::int32_t>(std::lround(metres * 1000.0));
}
inline double from_whole_mm(std::int32_t mm) { return mm / 1000.0; }

inline double to_degrees(double radians) { return radians * 180.0 / std::numbers::pi; }
inline double from_degrees(double degrees) { return degrees * std::numbers::pi / 180.0; }

inline double to_rpm(double radians_per_second) { return radians_per_second * 30.0 / std::numbers::pi; }
inline double from_rpm(double rpm) { return rpm * std::numbers::pi / 30.0; }

inline std::int64_t to_us(world::Duration duration) {
  return std::chrono::round<std::chrono::microseconds>(duration).count();
}
/// Limited to 31 years, so that sums and differences with instants of the wire stay within
/// what nanoseconds hold.
inline world::Duration from_us(std::int64_t us) {
  constexpr std::int64_t limit = 1'000'000'000'000'000;
  return std::chrono::microseconds{us < -limit ? -limit : us > limit ? limit : us};
}

/// Farther out than this is not a position [mm]. Ours: the largest field is 12 m long.
inline constexpr float max_coordinate_mm = 100'000;
/// False for NaN too.
inline bool is_coordinate(float mm) { return std::abs(mm) <= max_coordinate_mm; }

}  // namespace wire
