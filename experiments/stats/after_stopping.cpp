#include "experiments/stats/after_stopping.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments/stats/distributions.h"
#include "experiments/stats/root.h"

namespace stats {
namespace {

/// weight(exponent) times P(low < standard normal < high), without losing small ones.
double weighted(double exponent, double low, double high) {
  const double inside = low > 0 ? normal_cdf(-low) - normal_cdf(-high) : normal_cdf(high) - normal_cdf(low);
  return inside > 0 ? std::exp(exponent + std::log(inside)) : 0;
}

/// Images of the start needed so that the next one is twelve deviations away.
int images(double deviation, double width) { return 2 + static_cast<int>(6 * deviation / width); }

/// P(it ends worse than it did | drift). The walk is free until `first`, then between the bounds.
class Worse {
 public:
  Worse(const SequentialState& state, const SequentialPlan& plan)
      : state_(state),
        hypotheses_(plan.hypotheses),
        end_(static_cast<double>(state.used)),
        first_(static_cast<double>(std::min(plan.first_look, state.used))) {}

  double operator()(double t) const {
    const double drift = expected_llr(t, hypotheses_);
    const double variance = llr_variance(t, hypotheses_);
    const double mean = drift * first_;
    const double deviation = std::sqrt(variance * first_);
    if (end_ <= first_) return normal_cdf((state_.llr - mean) / deviation);
    const double low = state_.bounds.lower;
    const double high = state_.bounds.upper;
    // Simpson over where it was at the first look; beyond the bounds it had ended there.
    const double from = std::max(low, mean - 8 * deviation);
    const double to = std::min(high, mean + 8 * deviation);
    double worse = normal_cdf((low - mean) / deviation);
    if (from >= to) return worse;
    constexpr int steps = 200;
    const double width = (to - from) / steps;
    for (int i = 0; i <= steps; ++i) {
      const double x = from + width * i;
      const double z = (x - mean) / deviation;
      const double density = std::exp(-z * z / 2) / (std::sqrt(2 * std::numbers::pi) * deviation);
      const int weight = i == 0 || i == steps ? 1 : i % 2 == 1 ? 4 : 2;
      worse += density * width / 3 * weight * later(x, drift, variance);
    }
    return worse;
  }

 private:
  /// The same from `x` at the first look on.
  double later(double x, double drift, double variance) const {
    const double time = end_ - first_;
    const double low = state_.bounds.lower - x;
    const double high = state_.bounds.upper - x;
    if (low >= 0) return 1;
    if (high <= 0) return 0;
    if (state_.decision == Decision::AcceptH0) return absorbed_below(low, high, drift, variance, time);
    if (state_.decision == Decision::AcceptH1) return 1 - absorbed_below(-high, -low, -drift, variance, time);
    return absorbed_below(low, high, drift, variance, time) +
           inside_below(low, high, drift, variance, time, std::clamp(state_.llr - x, low, high));
  }

  const SequentialState& state_;
  const Hypotheses& hypotheses_;
  double end_;
  double first_;
};

}  // namespace

double absorbed_below(double low, double high, double drift, double variance, double time) {
  assert(low < 0 && high > 0);
  const double width = high - low;
  const double deviation = std::sqrt(variance * time);
  const double pull = std::abs(drift) / variance;
  // First passage densities of the images at distance d; the drift enters by Girsanov's factor.
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto passage = [&](double d) {
    return weighted(drift * low / variance - pull * d, (d - std::abs(drift) * time) / deviation, infinite) +
           weighted(drift * low / variance + pull * d, (d + std::abs(drift) * time) / deviation, infinite);
  };
  double sum = 0;
  const int most = images(deviation, width);
  for (int k = 0; k <= most; ++k) {
    sum += passage(2 * k * width - low);
    sum -= passage(2 * (k + 1) * width + low);
  }
  return std::clamp(sum, 0.0, 1.0);
}

double inside_below(double low, double high, double drift, double variance, double time, double level) {
  assert(low < 0 && high > 0 && level >= low && level <= high);
  const double width = high - low;
  const double deviation = std::sqrt(variance * time);
  const double shift = drift * time;
  const int most = images(deviation, width);
  double sum = 0;
  for (int k = -most; k <= most; ++k) {
    const double image = 2 * k * width;
    const double mirror = 2 * low - 2 * k * width;
    sum += weighted(drift * image / variance, (low - image - shift) / deviation,
                    (level - image - shift) / deviation);
    sum -= weighted(drift * mirror / variance, (low - mirror - shift) / deviation,
                    (level - mirror - shift) / deviation);
  }
  return std::clamp(sum, 0.0, 1.0);
}

double outcome_probability(const SequentialState& state, const SequentialPlan& plan, double t) {
  assert(state.used >= 1);
  return Worse(state, plan)(t);
}

Estimate after_stopping(const SequentialState& state, const SequentialPlan& plan, double confidence) {
  assert(confidence > 0 && confidence < 1);
  const double sign = plan.hypotheses.t1 > plan.hypotheses.t0 ? 1 : -1;  // where H1 lies
  const auto where = [&](double probability) {
    // P(worse) falls with the drift from 1 to 0; widen until it is bracketed.
    const double centre = (plan.hypotheses.t0 + plan.hypotheses.t1) / 2;
    const auto excess = [&](double t) { return outcome_probability(state, plan, t) - probability; };
    double reach = 8 / std::sqrt(static_cast<double>(state.used));
    while (excess(centre - sign * reach) < 0 && reach < 1e3) reach *= 2;
    const double low = centre - sign * reach;
    reach = 8 / std::sqrt(static_cast<double>(state.used));
    while (excess(centre + sign * reach) > 0 && reach < 1e3) reach *= 2;
    return root(excess, low, centre + sign * reach);
  };
  Estimate estimate;
  estimate.value = where(0.5);
  const double one = where((1 + confidence) / 2);
  const double other = where((1 - confidence) / 2);
  estimate.interval = {std::min(one, other), std::max(one, other)};
  return estimate;
}

}  // namespace stats
