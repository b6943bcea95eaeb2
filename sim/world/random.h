#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace world {

/// A seed of its own for every purpose: the same seed and name give the same stream, different names
/// unrelated ones.
std::uint64_t derived_seed(std::uint64_t seed, std::string_view name);

/// One named source of randomness. Copying it copies its position.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name) : engine_(derived_seed(seed, name)) {}

  /// Uniform in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  /// Standard normal.
  double gaussian() { return normal_(engine_); }
  /// Uniform among 0 .. count-1.
  /// @pre count > 0
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
  }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_;
};

}  // namespace world
