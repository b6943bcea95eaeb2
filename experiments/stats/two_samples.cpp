#include "experiments/stats/two_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/stats/distributions.h"

namespace stats {
namespace {

TTest unknown(double difference) {
  TTest test;
  test.difference = difference;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  test.interval = {-infinite, infinite};
  return test;
}

/// The rest, once difference, standard error and degrees of freedom are there.
void finish(TTest& test, double confidence) {
  constexpr double rounding = 1e-12;  // the deviation of equal values is this far from 0 at most
  if (test.standard_error <= rounding * std::max(1.0, std::abs(test.difference))) {
    test = unknown(test.difference);
    return;
  }
  test.known = true;
  test.t = test.difference / test.standard_error;
  test.p = std::min(1.0, 2 * t_cdf(-std::abs(test.t), test.freedom));
  const double half = t_quantile((1 + confidence) / 2, test.freedom) * test.standard_error;
  test.interval = {test.difference - half, test.difference + half};
}

}  // namespace

Interval newcombe(std::int64_t successes1, std::int64_t trials1, std::int64_t successes2,
                  std::int64_t trials2, double confidence) {
  if (trials1 == 0 || trials2 == 0) return {-1, 1};
  const double p1 = static_cast<double>(successes1) / static_cast<double>(trials1);
  const double p2 = static_cast<double>(successes2) / static_cast<double>(trials2);
  const Interval w1 = wilson(successes1, trials1, confidence);
  const Interval w2 = wilson(successes2, trials2, confidence);
  return {p1 - p2 - std::hypot(p1 - w1.low, w2.high - p2), p1 - p2 + std::hypot(w1.high - p1, p2 - w2.low)};
}

TTest welch(const Mean& first, const Mean& second, double confidence) {
  if (!first.has_error() || !second.has_error()) return unknown(first.mean - second.mean);
  TTest test;
  test.difference = first.mean - second.mean;
  const double v1 = first.standard_error * first.standard_error;
  const double v2 = second.standard_error * second.standard_error;
  test.standard_error = std::sqrt(v1 + v2);
  const double below =
      v1 * v1 / static_cast<double>(first.count - 1) + v2 * v2 / static_cast<double>(second.count - 1);
  test.freedom = below > 0 ? (v1 + v2) * (v1 + v2) / below : 1;
  finish(test, confidence);
  return test;
}

TTest t_test(const Mean& mean, double confidence) {
  if (!mean.has_error()) return unknown(mean.mean);
  TTest test;
  test.difference = mean.mean;
  test.standard_error = mean.standard_error;
  test.freedom = static_cast<double>(mean.count - 1);
  finish(test, confidence);
  return test;
}

}  // namespace stats
