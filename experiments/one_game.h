#pragma once

#include <iosfwd>
#include <optional>

#include "experiments/host/play.h"
#include "experiments/isolation.h"
#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

namespace commands {

/// A game in this process, bound to one processor; Ctrl-C and TERM end it.
struct OneGame {
  record::MatchRecord record;
  std::optional<int> signal;  ///< that ended it
};

/// Plays it and tells every call as it happens; null: silent.
///
/// @param settings  how it is run, as far as not decided here
OneGame play_one_game(const record::MatchConfig& config, std::ostream* calls, bool explain = false,
                      host::Options settings = {});

/// Checks the configuration, plays it and tells all of it, as text or JSON.
/// @param isolation  what the teams see
/// @return  the exit code
int tell_one_game(const record::MatchConfig& config, bool json, bool explain,
                  const IsolationOptions& isolation);

}  // namespace commands
