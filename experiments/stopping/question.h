#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/schedule/design.h"
#include "experiments/stats/sequential.h"

namespace stopping {

/// One thing an experiment asks, with one score per pair: is A better than B under this condition, or, of a
/// panel, does A do better than B against the same opponents.
struct Question {
  struct Term {
    std::size_t condition;  ///< index in the design
    double weight;          ///< of its score in the pair's score
  };
  std::string name;         ///< of the condition, or of the one that is played against the panel
  std::vector<Term> terms;  ///< of a panel: A's games count +1/k, B's -1/k, for k opponents
  bool panel = false;
};

/// The questions of a design, in the order of its conditions. Each condition belongs to one.
std::vector<Question> questions(const schedule::Design& design);

/// The score of a complete pair from team A's view: its mean goal difference a game, or its share of the
/// points (win 1, draw 1/2). A forfeit counts 0 to `forfeit_goals`.
///
/// @pre state.complete()
double pair_score(const record::PairState& state, schedule::Metric metric, int forfeit_goals);

/// The test of one question as the statistics want it.
///
/// Hypotheses of a game become those of a pair: times sqrt(2), or sqrt(k) for the difference of two teams
/// against k opponents, which is exact when games are independent. `alpha` is shared out evenly among the
/// design's questions (Bonferroni). Points against a panel are a difference that may take many values, so
/// they are tested like goals.
stats::SequentialPlan sequential_plan(const schedule::Design& design, const Question& question,
                                      std::size_t questions);

}  // namespace stopping
