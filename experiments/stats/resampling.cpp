#include "experiments/stats/resampling.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace stats {

Interval bootstrap(std::span<const double> values, double confidence, int draws, std::uint64_t seed) {
  // Of fewer values even the sign flips cannot reach 5 % (2 / 2^5 = 0.0625), and the ends would be the values
  // themselves; equal values have no spread to resample.
  constexpr std::size_t fewest = 6;
  const bool all_alike =
      std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
  if (values.size() < fewest || all_alike) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  Random random(seed);
  std::vector<double> means(static_cast<std::size_t>(draws));
  for (double& mean : means) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += values[random.below(values.size())];
    mean = sum / static_cast<double>(values.size());
  }
  std::sort(means.begin(), means.end());
  // The order statistics number (draws + 1) p, as usual.
  const double tail = (1 - confidence) / 2;
  const auto at = [&](double p) {
    const double number = std::round(p * (draws + 1)) - 1;
    return means[static_cast<std::size_t>(std::clamp(number, 0.0, static_cast<double>(draws - 1)))];
  };
  return {at(tail), at(1 - tail)};
}

double sign_flip(std::span<const double> values, int draws, std::uint64_t seed) {
  std::vector<double> sizes;
  double observed = 0;
  double total = 0;
  for (const double value : values) {
    if (value == 0) continue;
    sizes.push_back(std::abs(value));
    observed += value;
    total += std::abs(value);
  }
  if (sizes.empty()) return 1;
  const double limit = std::abs(observed) - 1e-9 * total;  // sums of the same values in another order
  constexpr std::size_t exact_up_to = 20;
  if (sizes.size() <= exact_up_to) {
    // Gray code: each pattern differs from the one before in one sign.
    const std::uint64_t patterns = std::uint64_t{1} << sizes.size();
    std::vector<char> negative(sizes.size(), 0);
    double sum = total;
    std::uint64_t as_far = 0;
    for (std::uint64_t pattern = 0;;) {
      if (std::abs(sum) >= limit) ++as_far;
      if (++pattern == patterns) break;
      const auto flip = static_cast<std::size_t>(std::countr_zero(pattern));
      sum += negative[flip] ? 2 * sizes[flip] : -2 * sizes[flip];
      negative[flip] = static_cast<char>(!negative[flip]);
    }
    return static_cast<double>(as_far) / static_cast<double>(patterns);
  }
  Random random(seed);
  std::int64_t as_far = 1;
  for (int draw = 0; draw < draws; ++draw) {
    double sum = 0;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (i % 64 == 0) bits = random.bits();
      sum += (bits & 1) != 0 ? sizes[i] : -sizes[i];
      bits >>= 1;
    }
    if (std::abs(sum) >= limit) ++as_far;
  }
  return static_cast<double>(as_far) / (draws + 1.0);
}

}  // namespace stats
