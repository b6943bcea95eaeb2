#pragma once

#include <cstdint>

#include "experiments/stats/intervals.h"

// Two groups of games that have nothing to do with each other, as two builds against the same opponent.
namespace stats {

/// Interval of the difference of two shares, first minus second.
///
/// Wilson's intervals of both, put together: low = d - sqrt((p1 - l1)^2 + (u2 - p2)^2), high likewise.
/// [-1, 1] when a group is empty.
///
/// Source  R. G. Newcombe, "Interval estimation for the difference between independent proportions",
///         Statistics in Medicine 17, 1998, method 10
Interval newcombe(std::int64_t successes1, std::int64_t trials1, std::int64_t successes2,
                  std::int64_t trials2, double confidence = usual_confidence);

/// A comparison of two means.
struct TTest {
  double difference = 0;      ///< first minus second
  double standard_error = 0;  ///< of the difference
  double freedom = 0;         ///< degrees of freedom
  double t = 0;
  double p = 1;        ///< two-sided
  Interval interval;   ///< of the difference
  bool known = false;  ///< false: too few values, or no spread among them; then p = 1, interval infinite
};

/// Two means of independent values, each with its own deviation.
///
/// Nothing is known (p = 1, infinite interval) when a group has fewer than two values, and when no group has
/// any spread: values that are all alike tell nothing of how far the next one may be.
///
/// Source  B. L. Welch, "The generalization of 'Student's' problem...", Biometrika 34, 1947
TTest welch(const Mean& first, const Mean& second, double confidence = usual_confidence);

/// A mean against zero: Student's test of the pairs' differences.
///
/// Nothing is known (p = 1, infinite interval) of fewer than two values, and of values without any spread.
TTest t_test(const Mean& mean, double confidence = usual_confidence);

}  // namespace stats
