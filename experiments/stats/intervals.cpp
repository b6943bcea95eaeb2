#include "experiments/stats/intervals.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "experiments/stats/distributions.h"

namespace stats {

Interval wilson(std::int64_t successes, std::int64_t trials, double confidence) {
  assert(successes >= 0 && successes <= trials);
  if (trials == 0) return {0, 1};
  const double n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double z = normal_quantile((1 + confidence) / 2);
  const double middle = p + z * z / (2 * n);
  const double half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const double scale = 1 + z * z / n;
  // At p = 0 and p = 1 one end is exact; rounding must not push it out.
  return {std::max(0.0, (middle - half) / scale), std::min(1.0, (middle + half) / scale)};
}

Mean mean_of(std::span<const double> values) {
  Mean result;
  result.count = static_cast<std::int64_t>(values.size());
  if (values.empty()) return result;
  const double n = static_cast<double>(values.size());
  for (const double value : values) result.mean += value;  // exact for goals
  result.mean /= n;
  if (values.size() < 2) return result;
  double squares = 0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  result.deviation = std::sqrt(squares / (n - 1));
  result.standard_error = result.deviation / std::sqrt(n);
  return result;
}

Interval t_interval(const Mean& mean, double confidence) {
  if (!mean.has_error()) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  const double half =
      t_quantile((1 + confidence) / 2, static_cast<double>(mean.count - 1)) * mean.standard_error;
  return {mean.mean - half, mean.mean + half};
}

}  // namespace stats
