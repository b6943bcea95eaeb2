#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "experiments/stats/intervals.h"

namespace stats {

/// How the two games of a pair hang together.
struct PairCorrelation {
  std::int64_t pairs = 0;
  double value = 0;           ///< of A's score in leg 0 and in leg 1; 0 while unknown
  double standard_error = 0;  ///< (1 - r^2) / sqrt(n - 1)
  Interval interval{-1, 1};   ///< Fisher's: tanh(atanh r +- z / sqrt(n - 3)); [-1, 1] with fewer than four
  bool known = false;         ///< three pairs or more, and both legs vary
};

/// Pearson's correlation of the two legs' scores.
///
/// The variance of a pair's mean is s^2 (1 + r) / 2: a negative r makes the night shorter by that much.
///
/// Source  R. A. Fisher, "On the 'probable error' of a coefficient of correlation", 1921
PairCorrelation pair_correlation(std::span<const std::array<double, 2>> pairs,
                                 double confidence = usual_confidence);

}  // namespace stats
