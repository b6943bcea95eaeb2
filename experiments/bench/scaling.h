#pragma once

#include <vector>

#include "experiments/bench/figures.h"
#include "experiments/record/match_config.h"

namespace bench {

/// The processors we may use, rising.
std::vector<int> processors();

/// Plays the game alone, then on as many processors at once, then alone again, each from the start of the
/// teams to their end; nothing is measured inside.
///
/// @throws std::invalid_argument when there are fewer processors than workers, std::runtime_error when a game
///         did not finish
Scaling measure_scaling(const record::MatchConfig& game, int workers);

}  // namespace bench
