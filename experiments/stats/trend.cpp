#include "experiments/stats/trend.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "experiments/stats/distributions.h"

namespace stats {
namespace {

/// P(|slope| of a random deal >= observed); the slope is sum (x - mean x) y over a constant.
double permutation(std::span<const SweepPoint> points, int draws, std::uint64_t seed) {
  std::vector<double> x;
  std::vector<double> y;
  for (const SweepPoint& point : points) {
    x.insert(x.end(), point.values.size(), point.x);
    y.insert(y.end(), point.values.begin(), point.values.end());
  }
  double mean = 0;
  for (const double one : x) mean += one / static_cast<double>(x.size());
  for (double& one : x) one -= mean;
  double mean_y = 0;
  for (const double one : y) mean_y += one / static_cast<double>(y.size());
  for (double& one : y) one -= mean_y;  // changes no slope, and keeps sums small
  double scale = 0;
  const auto slope = [&] {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
    return std::abs(sum);
  };
  for (std::size_t i = 0; i < x.size(); ++i) scale += std::abs(x[i] * y[i]);
  const double limit = slope() - 1e-9 * scale;
  Random random(seed);
  int as_steep = 1;
  for (int draw = 0; draw < draws; ++draw) {
    for (std::size_t i = y.size(); i > 1; --i) std::swap(y[i - 1], y[random.below(i)]);
    if (slope() >= limit) ++as_steep;
  }
  return as_steep / (draws + 1.0);
}

}  // namespace

Trend trend(std::span<const SweepPoint> points, double confidence, int draws, std::uint64_t seed) {
  Trend result;
  std::vector<SweepPoint> usable;
  std::vector<Mean> means;
  double smallest = std::numeric_limits<double>::infinity();
  for (const SweepPoint& point : points) {
    const Mean mean = mean_of(point.values);
    if (!mean.has_error()) continue;
    usable.push_back(point);
    means.push_back(mean);
    if (mean.standard_error > 0) smallest = std::min(smallest, mean.standard_error);
  }
  const bool different = std::any_of(usable.begin(), usable.end(),
                                     [&](const SweepPoint& point) { return point.x != usable.front().x; });
  if (!different) return result;
  if (std::isinf(smallest)) return result;  // no spread anywhere: nothing says how sure a slope is

  double weights = 0;
  double mean_x = 0;
  double mean_y = 0;
  std::vector<double> weight(usable.size());
  for (std::size_t i = 0; i < usable.size(); ++i) {
    const double error = std::max(means[i].standard_error, smallest);
    weight[i] = 1 / (error * error);
    weights += weight[i];
    mean_x += weight[i] * usable[i].x;
    mean_y += weight[i] * means[i].mean;
  }
  mean_x /= weights;
  mean_y /= weights;
  double xx = 0;
  double xy = 0;
  for (std::size_t i = 0; i < usable.size(); ++i) {
    xx += weight[i] * (usable[i].x - mean_x) * (usable[i].x - mean_x);
    xy += weight[i] * (usable[i].x - mean_x) * (means[i].mean - mean_y);
  }
  result.known = true;
  result.slope = xy / xx;
  result.intercept = mean_y - result.slope * mean_x;
  result.standard_error = 1 / std::sqrt(xx);
  const double half = normal_quantile((1 + confidence) / 2) * result.standard_error;
  result.interval = {result.slope - half, result.slope + half};
  result.p = 2 * normal_cdf(-std::abs(result.slope) / result.standard_error);
  result.permutation_p = permutation(usable, draws, seed);
  return result;
}

}  // namespace stats
