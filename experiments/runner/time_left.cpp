#include "experiments/runner/time_left.h"

#include <algorithm>
#include <cmath>

#include "experiments/stats/distributions.h"

namespace runner {

void TimeLeft::add(double seconds) {
  ++count_;
  const double difference = seconds - mean_;
  mean_ += difference / static_cast<double>(count_);
  squares_ += difference * (seconds - mean_);
}

std::optional<TimeLeft::Estimate> TimeLeft::estimate(std::size_t games, std::size_t workers) const {
  if (count_ < 2 || workers == 0) return std::nullopt;
  const auto n = static_cast<double>(games);
  const auto k = static_cast<double>(count_);
  const auto w = static_cast<double>(std::min(workers, std::max(games, std::size_t{1})));
  const double deviation = std::sqrt(squares_ / (k - 1));
  const double error = stats::t_quantile(0.975, k - 1) * deviation * std::sqrt(n + n * n / k) / w;
  const double seconds = n * mean_ / w;
  return Estimate{seconds, std::max(0.0, seconds - error), seconds + error};
}

}  // namespace runner
