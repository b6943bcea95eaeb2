#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "sim/world/random.h"
#include "sim/world/robot_id.h"

namespace vision {

/// A named source of randomness whose numbers have addresses instead of an order.
///
/// The number for an image, an object and a purpose depends on these, the seed and the name alone.
/// So a number that is not asked for cannot shift any other, no number has to be drawn and thrown away,
/// and a source is 8 bytes.
///
/// Source  the SplitMix64 generator: Steele, Lea, Flood, "Fast splittable pseudorandom number generators",
///         OOPSLA 2014, with the counter computed instead of counted.
class Draws {
 public:
  Draws(std::uint64_t seed, std::string_view name) : key_(world::derived_seed(seed, name)) {}

  /// Uniform in [0, 1).
  /// @pre object < 4096 and purpose < 16
  double uniform(std::uint32_t image, unsigned object, unsigned purpose = 0) const {
    const std::uint64_t address =
        (std::uint64_t{image} << 16) | (std::uint64_t{object} << 4) | std::uint64_t{purpose};
    return static_cast<double>(mixed(key_ + (address + 1) * 0x9e3779b97f4a7c15) >> 11) * 0x1.0p-53;
  }
  /// Standard normal (Box and Muller), of the uniform numbers of this purpose and the next one.
  double gaussian(std::uint32_t image, unsigned object, unsigned purpose = 0) const {
    const double radius = std::sqrt(-2 * std::log(1 - uniform(image, object, purpose)));
    return radius * std::cos(2 * std::numbers::pi * uniform(image, object, purpose + 1));
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t key_;
};

/// The addresses of objects: the ball is 0, robots follow.
inline constexpr unsigned ball_object = 0;
inline constexpr unsigned object_count = 1 + 2 * (world::max_robot_number + 1);
constexpr unsigned object_of(world::RobotId id) {
  return 1 + (id.team == world::Team::Blue ? world::max_robot_number + 1U : 0U) + id.number;
}

}  // namespace vision
