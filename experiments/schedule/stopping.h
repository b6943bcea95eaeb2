#pragma once

#include <optional>

namespace schedule {

/// When a run has shown enough.
enum class StopRule {
  Fixed,      ///< after the design's number of pairs
  Precision,  ///< when the standard error of the goal difference is small enough
  Sequential  ///< when a sequential test has chosen between two hypotheses
};

/// What a sequential test is about, always team A against team B.
enum class Metric {
  GoalDifference,  ///< goals of A minus goals of B
  Points           ///< share of the points: 1 for a win of A, 1/2 for a draw
};

/// The rule of an experiment, fixed before its first game; `pairs` of the design is the most it may take.
struct Stopping {
  StopRule rule = StopRule::Fixed;
  Metric metric = Metric::GoalDifference;
  /// Precision: [goals a game] the standard error to be reached.
  double standard_error = 0.1;
  /// Sequential: the two hypotheses, h0 < h1, each the mean score of a game in standard deviations of one
  /// game (0.2 is 0.18 goals a game where both teams together score 0.8,).
  double h0 = 0;
  double h1 = 0.2;
  double alpha = 0.05;           ///< chance to accept h1 when h0 is true, over all conditions together
  double beta = 0.05;            ///< chance to accept h0 when h1 is true, of each condition
  int minimum_pairs = 8;         ///< before the first look (Precision: 25, since a standard error needs them)
  int batch_pairs = 4;           ///< between two looks
  std::optional<double> clip{};  ///< [goals] a pair's mean goal difference counts at most this much
  bool operator==(const Stopping&) const = default;
};

}  // namespace schedule
