#include "experiments/stats/power.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "experiments/stats/distributions.h"

namespace stats {
namespace {

double both_quantiles(const PowerPlan& plan) {
  return normal_quantile(1 - plan.level / 2) + normal_quantile(plan.power);
}

std::int64_t rounded_up(double value) { return std::max<std::int64_t>(2, std::llround(std::ceil(value))); }

}  // namespace

double detectable_effect(std::int64_t count, const PowerPlan& plan) {
  assert(count > 0);
  return both_quantiles(plan) / std::sqrt(static_cast<double>(count));
}

std::int64_t needed_for_effect(double t, const PowerPlan& plan) {
  assert(t != 0);
  const double ratio = both_quantiles(plan) / t;
  return rounded_up(ratio * ratio);
}

double pair_deviation(double game_deviation, double correlation) {
  return game_deviation * std::sqrt((1 + correlation) / 2);
}

double detectable_goal_difference(std::int64_t pairs, double game_deviation, double correlation,
                                  const PowerPlan& plan) {
  return detectable_effect(pairs, plan) * pair_deviation(game_deviation, correlation);
}

std::int64_t pairs_for_goal_difference(double difference, double game_deviation, double correlation,
                                       const PowerPlan& plan) {
  return needed_for_effect(difference / pair_deviation(game_deviation, correlation), plan);
}

double detectable_win_share(std::int64_t pairs, double draws, double correlation, const PowerPlan& plan) {
  assert(draws >= 0 && draws < 1);
  // d = k sqrt((1 - draws - d^2)(1 + r)/2), k = (z_a + z_b)/sqrt(pairs), solved for d.
  const double k = detectable_effect(pairs, plan);
  const double scale = k * k * (1 + correlation) / 2;
  return std::min(1 - draws, std::sqrt(scale * (1 - draws) / (1 + scale)));
}

std::int64_t pairs_for_win_share(double difference, double draws, double correlation, const PowerPlan& plan) {
  assert(difference != 0 && std::abs(difference) <= 1 - draws);
  const double deviation = std::sqrt(std::max(0.0, 1 - draws - difference * difference));
  if (deviation == 0) return 2;
  return needed_for_effect(difference / pair_deviation(deviation, correlation), plan);
}

double power_of(std::int64_t count, double t, double level) {
  const double z = normal_quantile(1 - level / 2);
  const double shift = t * std::sqrt(static_cast<double>(count));
  return normal_cdf(shift - z) + normal_cdf(-shift - z);
}

}  // namespace stats
