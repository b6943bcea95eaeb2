#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// One row of the cost table: what one part of a tick costs.
struct Row {
  std::string part;
  double mean = 0;  ///< [s]
  // Absent (negative) where only a sum over the game is known.
  double median = -1;       ///< [s]
  double ninety_nine = -1;  ///< [s] 99 % of the ticks cost less
};

/// Mean, median and 99 % quantile of the times of one part.
Row row_of(std::string part, std::vector<double> seconds);

/// Games played at the same time, each on a processor of its own.
struct Scaling {
  int workers = 0;
  double alone = 0;     ///< games per hour of one worker
  double together = 0;  ///< of all
  double ratio() const { return together / alone; }
};

/// What `matchday bench` measured.
struct Figures {
  std::string realism;
  std::string hash;
  std::int64_t ticks = 0;
  double loop_seconds = 0;       ///< wall, of the stepped ticks
  double reference_tick = 0;     ///< [s] processor time of one tick of the reference scene
  std::vector<Row> rows;         ///< in DESIGN's order
  double sum = 0;                ///< [s] of the rows' means
  double host_cpu = 0;           ///< [s] processor time of the host, whole game
  double teams_cpu = 0;          ///< [s] of both teams, whole game
  std::int64_t memory_host = 0;  ///< [bytes] peaks
  std::int64_t memory_yellow = 0;
  std::int64_t memory_blue = 0;
  double messages_per_tick = 0;
  double bytes_out_per_tick = 0;  ///< to both teams
  double bytes_in_per_tick = 0;   ///< from both teams
  double calls_per_tick = 0;      ///< of the system, by the host for the channels
  double switches_per_tick = 0;   ///< from one process to another, all three
  std::optional<Scaling> scaling;

  double tick_wall() const { return loop_seconds / static_cast<double>(ticks); }
  /// Simulated time over wall time, stepped ticks only.
  double times_real_time() const;
  /// The same over processor time, which other load on the machine does not change.
  double times_real_time_cpu() const;
};

/// For a reader.
std::string table(const Figures& figures);
/// For `--compare` and for other programs.
std::string json(const Figures& figures);

/// Figures that `json` wrote; medians and quantiles stay unknown.
///
/// @param file  its name, for the sentence
/// @throws std::invalid_argument naming file and field when the text is damaged or another program's
Figures figures_from_json(const std::string& text, const std::string& file);

}  // namespace bench
