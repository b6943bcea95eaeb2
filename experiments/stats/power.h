#pragma once

#include <cstdint>

// How many games a question needs, and what a number of games can answer. Two-sided tests with the normal
// approximation; the t distribution needs about two pairs more.
namespace stats {

struct PowerPlan {
  double level = 0.05;  ///< of the two-sided test
  double power = 0.8;   ///< probability to see a difference that is there
};

/// The effect t = mean / deviation of one value that `count` values show with that power:
///
///   (z_a + z_b) / sqrt(n)
///
/// Source  harness reference 2.6: .396 for 50, .280 for 100, .162 for 300
double detectable_effect(std::int64_t count, const PowerPlan& plan = {});

/// The number of values that show the effect t, rounded up.
/// @pre t != 0
std::int64_t needed_for_effect(double t, const PowerPlan& plan = {});

/// Deviation of a pair's mean from the deviation of one game and the correlation within pairs:
/// s sqrt((1 + r) / 2).
double pair_deviation(double game_deviation, double correlation = 0);

/// The mean goal difference a game that `pairs` pairs show.
///
/// @param game_deviation  of one game's goal difference
double detectable_goal_difference(std::int64_t pairs, double game_deviation, double correlation = 0,
                                  const PowerPlan& plan = {});
std::int64_t pairs_for_goal_difference(double difference, double game_deviation, double correlation = 0,
                                       const PowerPlan& plan = {});

/// The difference of win shares, A's minus B's, that `pairs` pairs show.
///
/// One game gives +1, 0 or -1 with the given share of draws, so its deviation is sqrt(1 - draws - d^2).
///
/// @param draws  share of drawn games, in [0, 1)
/// @return       at most 1 - draws: the pairs are too few for any
double detectable_win_share(std::int64_t pairs, double draws, double correlation = 0,
                            const PowerPlan& plan = {});
std::int64_t pairs_for_win_share(double difference, double draws, double correlation = 0,
                                 const PowerPlan& plan = {});

/// Probability that the test over `count` values sees the effect t (either sign of the test counts).
double power_of(std::int64_t count, double t, double level = 0.05);

}  // namespace stats
