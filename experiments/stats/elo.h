#pragma once

#include "experiments/stats/intervals.h"

// The chess players' units, for those who think in them.
namespace stats {

/// Elo difference at which the expected score is `score`: -400 log10(1/score - 1); -+infinity at 0 and 1.
double elo(double score);

/// The inverse: 1 / (1 + 10^(-elo/400)).
double expected_score(double elo);

/// Elo of a mean score with its interval, the ends of the score's normal interval transformed and, outside of
/// (0, 1), infinite.
///
/// Source  cutechess, elo.cpp; fastchess, elo_pentanomial.cpp
struct EloEstimate {
  double value = 0;
  Interval interval;
};
EloEstimate elo_of(const Mean& scores, double confidence = usual_confidence);

/// Likelihood of superiority: P(A is better) = Phi((mean - 1/2) / standard error); 1/2 while unknown.
///
/// Source  fastchess
double likelihood_of_superiority(const Mean& scores);

/// Normalised Elo of an effect per game t = (score - 1/2) / deviation: 800 / ln 10 = 347.4 per unit.
///
/// Source  M. Van den Bergh, "Normalized Elo"
double normalised_elo(double t_per_game);

}  // namespace stats
