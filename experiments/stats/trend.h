#pragma once

#include <cstdint>
#include <span>

#include "experiments/stats/intervals.h"
#include "experiments/stats/random.h"

namespace stats {

/// One point of a sweep: what was set, and what came out in each pair played there.
struct SweepPoint {
  double x = 0;
  std::span<const double> values;
};

/// A straight line through a sweep.
struct Trend {
  double slope = 0;           ///< per unit of x
  double intercept = 0;       ///< at x = 0
  double standard_error = 0;  ///< of the slope, each point with its own deviation
  Interval interval{};        ///< of the slope
  double p = 1;               ///< two-sided, "the slope is 0", normal
  double permutation_p = 1;   ///< two-sided, "x does not matter": values dealt to the points anew
  bool known = false;  ///< two different x or more, each with two values or more, not all without spread
};

/// Is there a trend over a sweep: one question, whatever the number of points, so nothing has to be adjusted.
///
/// Weighted regression of the points' means on x, weights 1 / standard error^2 (a point without any spread
/// gets the smallest error of the others). Beside it a permutation test, which assumes nothing but that under
/// "no trend" all values come from one distribution: the |slope| of the unweighted regression of all values
/// on x, compared with `draws` random deals; the observed one counts as one more.
///
/// Source  harness reference 2.9; P. Armitage, "Tests for linear trends in proportions and frequencies", 1955
///         (the idea); E. S. Edgington, "Randomization Tests", 1980
Trend trend(std::span<const SweepPoint> points, double confidence = usual_confidence, int draws = 10'000,
            std::uint64_t seed = resampling_seed);

}  // namespace stats
