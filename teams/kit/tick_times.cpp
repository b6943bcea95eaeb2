#include "teams/kit/tick_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>

namespace kit {
namespace {

constexpr double width = 1e-7;  // [s] of a column of the histogram

}  // namespace

void TickTimes::add(double seconds) {
  seconds = std::max(seconds, 0.0);
  const double column = std::min(seconds / width, static_cast<double>(counts_.size() - 1));
  ++counts_[static_cast<std::size_t>(column)];
  ++ticks_;
  sum_ += seconds;
  greatest_ = std::max(greatest_, seconds);
}

double TickTimes::mean() const { return ticks_ == 0 ? 0 : sum_ / static_cast<double>(ticks_); }

double TickTimes::quantile(double share) const {
  const auto wanted = static_cast<std::int64_t>(std::ceil(share * static_cast<double>(ticks_)));
  std::int64_t sum = 0;
  for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
    sum += counts_[i];
    if (sum >= wanted) return std::min(static_cast<double>(i + 1) * width, greatest_);
  }
  return greatest_;
}

std::string TickTimes::line() const {
  return fmt::format("tick_times ticks={} mean_us={:.2f} median_us={:.1f} p99_us={:.1f} greatest_us={:.1f}",
                     ticks_, mean() * 1e6, quantile(0.5) * 1e6, quantile(0.99) * 1e6, greatest_ * 1e6);
}

double thread_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace kit
