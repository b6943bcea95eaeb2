#include "experiments/bench/team_times.h"

#include <sstream>

namespace bench {
namespace {

// The number after " key=", in microseconds.
std::optional<double> seconds_of(const std::string& line, const std::string& key) {
  const std::size_t at = line.find(" " + key + "=");
  if (at == std::string::npos) return {};
  std::istringstream text(line.substr(at + key.size() + 2));
  double value = 0;
  if (!(text >> value)) return {};
  return value * 1e-6;
}

}  // namespace

std::optional<TeamTimes> team_times(const std::string& log) {
  std::optional<TeamTimes> times;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("tick_times ")) continue;
    const auto median = seconds_of(line, "median_us");
    const auto ninety_nine = seconds_of(line, "p99_us");
    if (median && ninety_nine) times = TeamTimes{*median, *ninety_nine};
  }
  return times;
}

}  // namespace bench
