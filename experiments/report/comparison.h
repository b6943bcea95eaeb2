#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/stats/intervals.h"
#include "experiments/stats/two_samples.h"

namespace report {

/// The two games of a complete pair, by leg.
using Pair = std::array<const record::Attempt*, 2>;

/// One match statistic of both teams under one condition.
struct Comparison {
  std::string name;   ///< "shots"; of offences "fouls", "foul_AimlessKick"
  std::string label;  ///< for readers
  int decimals = 1;
  stats::Mean a;  ///< a game
  stats::Mean b;
  stats::TTest test;  ///< A minus B, over pairs: both teams play the same game, so their numbers are related
  double p_holm = 1;  ///< adjusted for the number of statistics compared
};

/// One number of the game as a whole.
struct GameNumber {
  std::string name;
  std::string label;
  int decimals = 1;
  stats::Mean value;  ///< a game
};

/// Every statistic of record::team_statistics, then the offences called, together and by kind.
///
/// Only pairs of which both games were played to their end; a statistic that says nothing in a game (passes
/// completed of no passes) leaves out that pair. Offences nobody committed are left out.
std::vector<Comparison> compare(std::span<const Pair> pairs);

std::vector<GameNumber> game_numbers(std::span<const Pair> pairs);

}  // namespace report
