#pragma once

#include <cstdint>
#include <span>

#include "experiments/stats/intervals.h"
#include "experiments/stats/random.h"

// Answers that assume no distribution: from the values themselves, drawn again. Same values, same answer.
namespace stats {

/// Percentile bootstrap interval of a mean: `draws` samples of the same size drawn with replacement.
///
/// Give values that are independent of each other: means of pairs, not games.
/// [-inf, inf] with fewer than two.
///
/// Accuracy  the ends vary by about 1 % of the width from seed to seed with 10 000 draws; too narrow by some
///           percent with fewer than twenty values
/// Source    B. Efron, R. Tibshirani, "An Introduction to the Bootstrap", 1993, Ch. 13
Interval bootstrap(std::span<const double> values, double confidence = usual_confidence, int draws = 10'000,
                   std::uint64_t seed = resampling_seed);

/// Two-sided p of "positive and negative differences are equally likely, size by size": the share of all sign
/// patterns of the values whose sum is at least as far from zero.
///
/// Exact over all 2^n patterns up to 20 values that are not zero, else `draws` random patterns, in which case
/// the observed one counts as one more, so that p is never 0.
///
/// Source  R. A. Fisher, "The Design of Experiments", 1935, Sec. 21
double sign_flip(std::span<const double> values, int draws = 100'000, std::uint64_t seed = resampling_seed);

}  // namespace stats
