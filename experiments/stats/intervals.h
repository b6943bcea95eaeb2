#pragma once

#include <cstdint>
#include <span>

namespace stats {

struct Interval {
  double low = 0;
  double high = 0;
};

inline constexpr double usual_confidence = 0.95;

/// Wilson's interval of a share, `successes` of `trials`; [0, 1] without trials.
///
///   (p + z^2/2n +- z sqrt(p (1 - p)/n + z^2/4n^2)) / (1 + z^2/n)
///
/// Covers well also for few trials and shares near 0 and 1, unlike the usual p +- z sqrt(p (1 - p)/n).
///
/// @pre 0 <= successes <= trials
/// Source  E. B. Wilson, "Probable inference, the law of succession, and statistical inference", 1927
Interval wilson(std::int64_t successes, std::int64_t trials, double confidence = usual_confidence);

/// Mean of independent values, and how well it is known.
struct Mean {
  std::int64_t count = 0;
  double mean = 0;            ///< 0 without values
  double deviation = 0;       ///< of one value: sample standard deviation; 0 with fewer than two
  double standard_error = 0;  ///< of the mean: deviation / sqrt(count); 0 with fewer than two: unknown
  bool has_error() const { return count >= 2; }
};

Mean mean_of(std::span<const double> values);

/// Student's interval of a mean; nothing known (-inf, inf) with fewer than two values.
Interval t_interval(const Mean& mean, double confidence = usual_confidence);

}  // namespace stats
