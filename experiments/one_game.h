#pragma once

#include <iosfwd>
#include <optional>

#include "experiments/host/play.h"
#include "experiments/isolation.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"
#include "experiments/schedule/limits.h"

namespace commands {

/// A game in this process, bound to one processor; Ctrl-C and TERM end it.
struct OneGame {
  record::MatchRecord record;
  std::optional<int> signal;  ///< that ended it
};

/// As the options of a game have it.
void set_team_time(const schedule::TeamTime& time, host::Options& options);

/// Plays it and tells every call as it happens; null: silent.
///
/// @param settings  how it is run, as far as not decided here
OneGame play_one_game(const record::MatchConfig& config, std::ostream* calls, bool explain = false,
                      host::Options settings = {});

/// Checks the configuration, plays it and tells all of it, as text or JSON.
/// @param isolation  what the teams see
/// @param time       what a team may take
/// @return  the exit code
int tell_one_game(const record::MatchConfig& config, bool json, bool explain,
                  const IsolationOptions& isolation, const schedule::TeamTime& time = {});

}  // namespace commands
