#pragma once

#include <cstddef>
#include <optional>

namespace runner {

/// How long the games of a run took, and how long the rest will.
class TimeLeft {
 public:
  struct Estimate {
    double seconds = 0;
    double low = 0;  ///< 95 % interval
    double high = 0;
  };

  void add(double seconds);

  /// For `games` more, `workers` at a time; nothing before the second game.
  ///
  /// With mean m and deviation s of the k games so far, n games on w workers take
  ///
  ///   n m / w +- q s sqrt(n + n^2 / k) / w
  ///
  /// The error is that of their own scatter and of the mean; q is Student's quantile for k - 1 degrees
  /// of freedom (games are taken as independent and normal). The end of a run, when not all workers
  /// have a game, is neglected.
  std::optional<Estimate> estimate(std::size_t games, std::size_t workers) const;

 private:
  std::size_t count_ = 0;
  double mean_ = 0;
  double squares_ = 0;  ///< sum of squared deviations from the mean (Welford)
};

}  // namespace runner
