#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace calibrate {

/// A number with its standard error and the samples it comes from.
struct Estimate {
  double value = 0;
  double error = 0;
  std::size_t samples = 0;
};

/// The value below which the share `p` of the values lies, interpolated. Reorders `values`.
/// @pre values is not empty, 0 <= p <= 1
double quantile(std::span<double> values, double p);
inline double median(std::span<double> values) { return quantile(values, 0.5); }

/// Standard deviation of Gaussian values around zero from the median of their sizes: a few wild ones do not
/// matter. Reorders `values`.
///
/// The error is 1.166 sigma / sqrt(n / `repetition`) (37 % efficiency), where `repetition` says how many
/// samples tell what one independent sample would.
/// @pre values is not empty
Estimate spread(std::span<double> values, double repetition = 1);

/// The quantile `p` with its error from the neighbouring order statistics, sqrt(n p (1 - p)) ranks away.
/// Reorders `values`.
/// @pre values is not empty, repetition as in `spread`
Estimate high_quantile(std::span<double> values, double p, double repetition);

/// Mean of estimates weighted by 1/error^2, without those more than 5 errors off the weighted median. The
/// error grows by sqrt(chi^2 / (n - 1)) where the estimates scatter more than their errors say (Birge).
/// @pre estimates is not empty, all errors are positive
Estimate combined(std::vector<Estimate> estimates);

}  // namespace calibrate
