#include "autoref/calibrate/statistics.h"

#include <algorithm>
#include <cmath>

namespace calibrate {

double quantile(std::span<double> values, double p) {
  const double rank = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  const double fraction = rank - static_cast<double>(below);
  if (fraction == 0) return *at;
  return *at + fraction * (*std::min_element(at + 1, values.end()) - *at);
}

Estimate spread(std::span<double> values, double repetition) {
  constexpr double median_of_size = 0.6744897501960817;  // of a standard normal variable
  for (double& value : values) value = std::abs(value);
  const double sigma = median(values) / median_of_size;
  const double n = static_cast<double>(values.size()) / repetition;
  return {sigma, 1.166 * sigma / std::sqrt(std::max(n, 1.0)), values.size()};
}

Estimate high_quantile(std::span<double> values, double p, double repetition) {
  const double n = static_cast<double>(values.size());
  const double value = quantile(values, p);
  const double share = std::sqrt(p * (1 - p) * repetition / n);
  const double above = quantile(values, std::min(1.0, p + share));
  const double below = quantile(values, std::max(0.0, p - share));
  return {value, (above - below) / 2, values.size()};
}

Estimate combined(std::vector<Estimate> estimates) {
  const auto weight = [](const Estimate& e) { return 1 / (e.error * e.error); };
  std::ranges::sort(estimates, {}, &Estimate::value);
  double total = 0;
  for (const Estimate& e : estimates) total += weight(e);
  double middle = estimates.back().value;
  double passed = 0;
  for (const Estimate& e : estimates) {
    passed += weight(e);
    if (passed >= total / 2) {
      middle = e.value;
      break;
    }
  }
  std::erase_if(estimates, [&](const Estimate& e) { return std::abs(e.value - middle) > 5 * e.error; });
  double sum = 0;
  double sum_of_weights = 0;
  for (const Estimate& e : estimates) {
    sum += weight(e) * e.value;
    sum_of_weights += weight(e);
  }
  const double mean = sum / sum_of_weights;
  double chi_squared = 0;
  for (const Estimate& e : estimates) chi_squared += weight(e) * (e.value - mean) * (e.value - mean);
  const double freedom = std::max(1.0, static_cast<double>(estimates.size()) - 1);
  const double scatter = std::sqrt(std::max(1.0, chi_squared / freedom));
  return {mean, scatter / std::sqrt(sum_of_weights), estimates.size()};
}

}  // namespace calibrate
