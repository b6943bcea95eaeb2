#include "experiments/stats/correlation.h"

#include <cmath>

#include "experiments/stats/distributions.h"

namespace stats {

PairCorrelation pair_correlation(std::span<const std::array<double, 2>> pairs, double confidence) {
  PairCorrelation result;
  result.pairs = static_cast<std::int64_t>(pairs.size());
  const double n = static_cast<double>(pairs.size());
  if (pairs.size() < 3) return result;
  double mean0 = 0;
  double mean1 = 0;
  for (const auto& [x, y] : pairs) {
    mean0 += x / n;
    mean1 += y / n;
  }
  double xx = 0;
  double yy = 0;
  double xy = 0;
  for (const auto& [x, y] : pairs) {
    xx += (x - mean0) * (x - mean0);
    yy += (y - mean1) * (y - mean1);
    xy += (x - mean0) * (y - mean1);
  }
  if (xx == 0 || yy == 0) return result;
  const double r = xy / std::sqrt(xx * yy);
  result.known = true;
  result.value = r;
  result.standard_error = (1 - r * r) / std::sqrt(n - 1);
  if (n < 4) return result;
  if (std::abs(r) >= 1) {
    result.interval = {r, r};
    return result;
  }
  const double half = normal_quantile((1 + confidence) / 2) / std::sqrt(n - 3);
  result.interval = {std::tanh(std::atanh(r) - half), std::tanh(std::atanh(r) + half)};
  return result;
}

}  // namespace stats
