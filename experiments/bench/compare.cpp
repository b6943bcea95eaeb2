#include "experiments/bench/compare.h"

#include <fmt/format.h>

#include <algorithm>

namespace bench {
namespace {

std::string line(const std::string& what, const std::string& unit, double before, double now, int digits) {
  const std::string ratio = before > 0 ? fmt::format("{:8.3f}", now / before) : "       -";
  return fmt::format("  {:<28}{:>14.{}f}{:>14.{}f}{}  {}\n", what, before, digits, now, digits, ratio, unit);
}

const Row* find(const Figures& figures, const std::string& part) {
  const auto row = std::find_if(figures.rows.begin(), figures.rows.end(),
                                [&](const Row& candidate) { return candidate.part == part; });
  return row == figures.rows.end() ? nullptr : &*row;
}

double mebibytes(const Figures& figures) {
  return static_cast<double>(figures.memory_host + figures.memory_yellow + figures.memory_blue) / (1 << 20);
}

}  // namespace

std::string comparison(const Figures& before, const Figures& now) {
  std::string text = fmt::format("  {:<28}{:>14}{:>14}{:>8}\n", "", "before", "now", "ratio");
  const std::string unit = "of the reference scene";
  for (const Row& row : now.rows) {
    const Row* old = find(before, row.part);
    if (old == nullptr) {
      text += fmt::format("  {:<28}{:>14}{:>14.3f}{:>8}  {}\n", row.part, "-", row.mean / now.reference_tick,
                          "-", unit);
    } else {
      text += line(row.part, unit, old->mean / before.reference_tick, row.mean / now.reference_tick, 3);
    }
  }
  for (const Row& row : before.rows) {
    if (find(now, row.part) != nullptr) continue;
    text += fmt::format("  {:<28}{:>14.3f}{:>14}{:>8}  {}\n", row.part, row.mean / before.reference_tick, "-",
                        "-", unit);
  }
  const auto cpu = [](const Figures& figures) {
    return (figures.host_cpu + figures.teams_cpu) / static_cast<double>(figures.ticks) /
           figures.reference_tick;
  };
  text += line("sum", unit, before.sum / before.reference_tick, now.sum / now.reference_tick, 3);
  text += line("measured, wall", unit, before.tick_wall() / before.reference_tick,
               now.tick_wall() / now.reference_tick, 3);
  text += line("measured, processor", unit, cpu(before), cpu(now), 3);
  text += line("reference scene", "us a tick", before.reference_tick * 1e6, now.reference_tick * 1e6, 1);
  text += line("times real time", "by wall time", before.times_real_time(), now.times_real_time(), 0);
  text += line("times real time", "by processor time", before.times_real_time_cpu(),
               now.times_real_time_cpu(), 0);
  text += line("peak memory", "MiB together", mebibytes(before), mebibytes(now), 1);
  text += line("messages", "a tick", before.messages_per_tick, now.messages_per_tick, 0);
  text += line("bytes to the teams", "a tick", before.bytes_out_per_tick, now.bytes_out_per_tick, 0);
  text += line("bytes from the teams", "a tick", before.bytes_in_per_tick, now.bytes_in_per_tick, 0);
  text += line("system calls of the host", "a tick", before.calls_per_tick, now.calls_per_tick, 2);
  text += line("switches", "a tick", before.switches_per_tick, now.switches_per_tick, 2);
  if (before.scaling && now.scaling && before.scaling->workers == now.scaling->workers) {
    text += line(fmt::format("games per hour, {} workers", now.scaling->workers), "",
                 before.scaling->together, now.scaling->together, 0);
  }
  if (before.realism != now.realism) {
    text += "The realism differs: " + before.realism + " before, " + now.realism + " now.\n";
  }
  if (before.hash != now.hash) text += "The games differ (hash): costs are of different play.\n";
  return text;
}

}  // namespace bench
