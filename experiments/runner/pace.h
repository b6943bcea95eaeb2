#pragma once

#include <string>
#include <vector>

#include "experiments/record/match_config.h"
#include "experiments/record/match_record.h"
#include "experiments/schedule/design.h"

namespace runner {

/// What one tick costs when two programs meet, from short games between them.
struct Pace {
  double tick = 0;                    ///< [s] of the clock, on one processor
  world::PerTeam<double> own{};       ///< [s] of it that is each team's own time
  world::PerTeam<std::string> names;  ///< of the teams
  double games = 0;                   ///< of the design that the two play
};

/// @param config   of the short games
/// @param records  of them, as long as they may be; without a tick the pace is 0
Pace pace_of(const record::MatchConfig& config, const std::vector<record::MatchRecord>& records,
             double games);

/// The ticks of a full game of the design, without extra time.
double full_game_ticks(const schedule::Design& design);

/// The time [s] all games take, so many at a time.
double expected_seconds(const schedule::Design& design, const std::vector<Pace>& paces, std::size_t places);

/// A team that would use up what the design allows it in every game, in one sentence; empty when none would.
std::string budget_problem(const schedule::Design& design, const Pace& pace);

/// The team that makes the games take longer than a night of 10 h, in one sentence; empty when none does.
std::string slowest_team(const schedule::Design& design, const std::vector<Pace>& paces, std::size_t places);

}  // namespace runner
