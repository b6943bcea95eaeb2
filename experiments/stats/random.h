#pragma once

#include <cstdint>

namespace stats {

/// A seeded stream of numbers for resampling: the same seed gives the same answer on any machine.
///
/// SplitMix64: one 64-bit state, passes the usual batteries, and quick enough for 10^9 draws.
///
/// Source  G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// In 0 .. count - 1; wrong by at most count / 2^53.
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
  }

 private:
  std::uint64_t state_;
};

inline constexpr std::uint64_t resampling_seed = 20'150'719;  ///< ours: any fixed number

}  // namespace stats
