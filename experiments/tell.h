#pragma once

#include <iosfwd>
#include <string>

#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"

// How a single game is told to a reader.
namespace commands {

/// Preset, rule set, seed and teams, before the game.
void tell_circumstances(const record::MatchConfig& config, std::ostream& out);

/// One call as one line, in the columns of `ssl-autoref replay`.
std::string call_line(const record::CallEntry& call, const world::PerTeam<int>& score);

/// Score, how it ended, statistics and hash, after the game.
void tell_result(const record::MatchConfig& config, const record::MatchRecord& record, std::ostream& out);

}  // namespace commands
