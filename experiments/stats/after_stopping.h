#pragma once

#include "experiments/stats/intervals.h"
#include "experiments/stats/sequential.h"

// What a sequential test says about the size of the effect, once it has stopped.
namespace stats {

/// An estimate that has been corrected for having stopped when it looked good.
struct Estimate {
  double value = 0;   ///< median-unbiased: as often too high as too low
  Interval interval;  ///< covers as often as it says
};

/// The effect t after a sequential test, corrected for the stopping.
///
/// The mean of the scores is too far from zero when a test stops early because of them (on passing tests of
/// H1: t = 0.2 it is +0.225 on average when the truth is 0). Outcomes are ordered from bad to good:
/// - stopped at the lower bound: the earlier the worse
/// - at the cap: by the log-likelihood ratio
/// - stopped at the upper bound: the earlier the better
///
/// The value is the t for which an outcome at most as good has probability 1/2; the interval's ends have
/// (1 -+ confidence)/2. The ratio is taken as Brownian motion with `expected_llr` and `llr_variance` per
/// pair, free until the first look and between the bounds after it. Multiply by the score's deviation for
/// goals or points.
///
/// For a test that goes on, the present moment is taken as its cap.
///
/// @param state  as sequential_test left it; used >= 1
/// Accuracy  0.5 % of a standard error in the integral; the model's own error is some percent for few pairs
/// Source    fishtest, sprt.py and brownian.py; D. Siegmund, "Estimation following sequential tests",
///           Biometrika 65, 1978. We differ: no bounds before the first look.
Estimate after_stopping(const SequentialState& state, const SequentialPlan& plan,
                        double confidence = usual_confidence);

/// Probability of an outcome at most as good (as near to H1) as `state`, if the true effect were t; uniform
/// over [0, 1] for the true t.
double outcome_probability(const SequentialState& state, const SequentialPlan& plan, double t);

// The pieces, for tests. A particle starts at 0 between absorbing ends low < 0 < high and moves with `drift`
// and `variance` per unit of time.

/// P(it was absorbed at the lower end by `time`).
double absorbed_below(double low, double high, double drift, double variance, double time);

/// P(not yet absorbed at `time`, and below `level`), low <= level <= high.
double inside_below(double low, double high, double drift, double variance, double time, double level);

}  // namespace stats
