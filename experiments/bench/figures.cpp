#include "experiments/bench/figures.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <numeric>

#include "sim/world/time.h"

namespace bench {
namespace {

double quantile(std::vector<double>& values, double share) {
  const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + index, values.end());
  return values[static_cast<std::size_t>(index)];
}

template <class... Values>
std::string format(const char* pattern, Values... values) {
  const int size = std::snprintf(nullptr, 0, pattern, values...);
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  std::snprintf(text.data(), text.size(), pattern, values...);
  text.pop_back();
  return text;
}

std::string microseconds(double seconds) { return seconds < 0 ? "      " : format("%6.1f", seconds * 1e6); }
double mebibytes(std::int64_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

}  // namespace

Row row_of(std::string part, std::vector<double> seconds) {
  if (seconds.empty()) return {std::move(part)};
  const double mean =
      std::accumulate(seconds.begin(), seconds.end(), 0.0) / static_cast<double>(seconds.size());
  const double median = quantile(seconds, 0.5);
  return {std::move(part), mean, median, quantile(seconds, 0.99)};
}

double Figures::times_real_time() const { return world::tick_length / tick_wall(); }
double Figures::times_real_time_cpu() const {
  return world::tick_length * static_cast<double>(ticks) / (host_cpu + teams_cpu);
}

std::string table(const Figures& figures) {
  const double reference = figures.reference_tick;
  std::string text = format("standard game, preset %s, %lld ticks, hash %s\n\n", figures.realism.c_str(),
                            static_cast<long long>(figures.ticks), figures.hash.c_str());
  text += "cost of one tick [us]     mean  median    99 %   of reference scene\n";
  for (const Row& row : figures.rows) {
    text +=
        format("  %-20s  %s  %s  %s   %5.2f\n", row.part.c_str(), microseconds(row.mean).c_str(),
               microseconds(row.median).c_str(), microseconds(row.ninety_nine).c_str(), row.mean / reference);
  }
  text += format("  %-20s  %s                   %5.2f\n", "sum", microseconds(figures.sum).c_str(),
                 figures.sum / reference);
  text += format("  %-20s  %s                   %5.2f\n", "measured, wall",
                 microseconds(figures.tick_wall()).c_str(), figures.tick_wall() / reference);
  text += format("  %-20s  %s\n\n", "reference scene", microseconds(reference).c_str());
  text +=
      format("times real time per core  %.0f (by wall time of the stepped ticks), %.0f (by processor time)\n",
             figures.times_real_time(), figures.times_real_time_cpu());
  text +=
      format("peak memory [MiB]         %.0f host, %.0f yellow, %.0f blue, %.0f together\n",
             mebibytes(figures.memory_host), mebibytes(figures.memory_yellow), mebibytes(figures.memory_blue),
             mebibytes(figures.memory_host + figures.memory_yellow + figures.memory_blue));
  text += format(
      "channel per tick          %.0f messages, %.0f bytes out, %.0f bytes in, %.2f system calls of the "
      "host\n",
      figures.messages_per_tick, figures.bytes_out_per_tick, figures.bytes_in_per_tick,
      figures.calls_per_tick);
  text += format("switches per tick         %.2f between the three processes\n", figures.switches_per_tick);
  if (const auto& scaling = figures.scaling) {
    text += format("games per hour            %.0f with 1 worker, %.0f with %d, %.2f times as many\n",
                   scaling->alone, scaling->together, scaling->workers, scaling->ratio());
  }
  return text;
}

}  // namespace bench
