#pragma once

#include <cstdint>

#include "experiments/schedule/design.h"
#include "experiments/stats/after_stopping.h"
#include "experiments/stopping/watch.h"

namespace stopping {

/// The effect t = mean / deviation of a pair's score after a sequential test, corrected for having stopped
/// because of it.
///
/// The whole test is played again with normal scores of effect t, `runs` times from fixed seeds. The value is
/// the t for which a test ends with an effect at most as large as the one seen as often as with a larger one;
/// the interval's ends are those for which it does so in 97.5 % and 2.5 % (outcomes ordered by the effect
/// seen, Emerson and Fleming 1990).
///
/// stats::after_stopping does the same by formula, with outcomes ordered by the moment of stopping,
/// for small effects: it takes the log-likelihood ratio as Brownian motion. Above t = 1 a pair
/// it is far too low (12 pairs with t = 4.8 give 1.4), since the ratio is not linear in t there.
/// An A/B test often has such effects.
///
/// @param seen   mean / deviation of the scores at the stop
/// @param pairs  at the stop, at least 2
/// Accuracy  about a twelfth of a standard error at the interval's ends with 1000 runs
/// Source    S. Emerson and T. Fleming, "Parameter estimation following group sequential hypothesis testing",
///           Biometrika 77, 1990
stats::Estimate corrected_effect(double seen, int pairs, const stats::SequentialPlan& plan, int runs = 1000);

/// The same in goals a game or as a share of the points: times the deviation of the scores.
///
/// @pre standing.score.has_error()
stats::Estimate corrected(const Standing& standing, const schedule::Design& design);

}  // namespace stopping
