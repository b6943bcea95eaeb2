#pragma once

#include <optional>
#include <string>

namespace bench {

/// What a team says in its log about the processor time of its single ticks (teams/README, `--timing on`).
struct TeamTimes {
  double median = 0;       ///< [s]
  double ninety_nine = 0;  ///< [s] 99 % of the ticks took less
};

/// The last line "tick_times ... median_us=M ... p99_us=P ..." of a log; nothing when there is none.
std::optional<TeamTimes> team_times(const std::string& log);

}  // namespace bench
