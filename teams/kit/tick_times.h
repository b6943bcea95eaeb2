#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace kit {

/// How long the ticks of a team took: a histogram of processor time, for its log. Decides nothing.
class TickTimes {
 public:
  void add(double seconds);

  std::int64_t ticks() const { return ticks_; }
  double mean() const;                           ///< [s]; 0 without ticks
  double greatest() const { return greatest_; }  ///< [s]
  /// The time within which that share of the ticks was done: 0.5 is the median.
  ///
  /// @param share  in [0, 1]
  /// Accuracy  0.1 us too long at most; of times beyond 0.5 ms only the greatest is known
  double quantile(double share) const;  ///< [s]

  /// The line that `matchday bench` looks for in a team's log (teams/README):
  /// "tick_times ticks=3600 mean_us=12.3 median_us=11.8 p99_us=30.1 greatest_us=95.0"
  std::string line() const;

 private:
  std::array<std::uint32_t, 5000> counts_{};  // of 0.1 us; the last also of all longer ones
  std::int64_t ticks_ = 0;
  double sum_ = 0;       // [s]
  double greatest_ = 0;  // [s]
};

/// Processor time this thread has used [s].
double thread_seconds();

}  // namespace kit
