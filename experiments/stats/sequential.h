#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "experiments/stats/intervals.h"

// Sequential tests: play until the question is answered. The unit is the pair of games everywhere, so that
// nothing has to be assumed about how its two games hang together.
namespace stats {

/// The two answers the test chooses between, as effect sizes t = mean / standard deviation of one pair's
/// score (for points: of the score minus 1/2).
///
/// t of a pair is sqrt(2) times t of a game when the games of a pair are independent.
struct Hypotheses {
  double t0 = 0;    ///< H0
  double t1 = 0.2;  ///< H1, not equal to t0
};

/// Where the log-likelihood ratio stops the test.
struct Bounds {
  double lower = 0;  ///< H0 is accepted at or below it
  double upper = 0;  ///< H1 is accepted at or above it
};

/// ln(beta / (1 - alpha)) and ln((1 - beta) / alpha).
///
/// @param alpha  probability to accept H1 when H0 holds, in (0, 1)
/// @param beta   probability to accept H0 when H1 holds, in (0, 1 - alpha)
/// Source  A. Wald, "Sequential tests of statistical hypotheses", 1945
Bounds wald_bounds(double alpha, double beta);

/// Log-likelihood ratio of t = t1 against t = t0 for any score, from its mean and deviation alone.
///
/// Normal scores with mean t sigma, sigma the most likely one for each t. With m and v the mean (from
/// `reference`) and variance of the values:
///
///   sigma(t) = (sqrt(t^2 m^2 + 4 (v + m^2)) - t m) / 2
///   l(t)     = ln sigma + (v + m^2) / (2 sigma^2) - t m / sigma + t^2 / 2
///   LLR      = n [l(t0) - l(t1)]
///
/// 0 with fewer than two values.
///
/// @param reference  the score of equal teams: 0 for a difference of goals, 1/2 for points
/// Source  the t-test as a generalised sequential test, as fishtest's "LLR_normalized_alt" (M. Van den Bergh,
///         "Normalized Elo practical", 4.2). We differ: its (n/2) ln[(1 + (t - t0)^2) / (1 + (t - t1)^2)] is
///         the same to second order in t, but shrinks again for t > 1, so that a team that wins 17:0 would
///         have to play longer than one that wins 2:1; this one never does.
double normalised_llr(const Mean& scores, const Hypotheses& hypotheses, double reference = 0);

/// The same per value when mean / deviation is t: the drift of the test's walk at the true effect t.
double expected_llr(double t, const Hypotheses& hypotheses);

/// Variance of the walk's steps there: (d expected_llr / dt)^2 (1 + t^2 / 2), the second factor from the
/// deviation being estimated too.
double llr_variance(double t, const Hypotheses& hypotheses);

/// Numbers of pairs by points: 0, 1/4, 1/2, 3/4, 1 of what there was to win.
using Pentanomial = std::array<double, 5>;

/// Counts of scores that are multiples of a quarter.
Pentanomial pentanomial(std::span<const double> scores);

/// Log-likelihood ratio of expected score s1 against s0, for the most likely distributions of the points that
/// have these expectations (generalised test: nothing is assumed about draws).
///
/// Counts of zero are taken as 0.001. Works for any number of equally spaced scores from 0 to 1: five for
/// pairs, three for single games.
///
/// @pre 0 < s0 < 1, 0 < s1 < 1
/// Source  fishtest, LLRcalc.py, "LLR_logistic"; M. Van den Bergh, "Comments on normalized Elo", MLE for
///         multinomial distributions, Prop. 1.1
double multinomial_llr(std::span<const double> counts, double s0, double s1);

/// The same for effect sizes t = (expected score - 1/2) / deviation.
///
/// Source  fishtest, LLRcalc.py, "LLR_normalized" and "MLE_t_value". We differ:
///         up to 200 rounds instead of 10, which do not suffice where nearly all scores are the same.
double multinomial_llr(std::span<const double> counts, const Hypotheses& hypotheses);

/// How much a test oversteps its bounds, learnt while it runs.
///
/// A walk with steps stops beyond a bound, not at it, so the test is more certain than asked and longer than
/// needed. By what it oversteps on average is E[d^2] / (2 E[d]) for the steps d between successive records;
/// the bounds are moved inwards by it.
///
/// Source  D. Siegmund, "Sequential Analysis", 1985, Ch. VIII; as in fishtest, stat_util.py, "update_SPRT"
class Overshoot {
 public:
  /// One look; the first one only says where the walk begins.
  void add(double llr);
  Bounds tightened(const Bounds& bounds) const;

 private:
  bool begun_ = false;
  double lowest_ = 0;
  double highest_ = 0;
  double sum_low_ = 0;
  double squares_low_ = 0;
  double sum_high_ = 0;
  double squares_high_ = 0;
};

/// Which score of a pair is tested, and how.
enum class Metric : std::uint8_t {
  GoalDifference,  ///< mean goal difference of the pair's two games (any real number): normalised_llr
  Points           ///< 0, 1/4, 1/2, 3/4, 1: multinomial_llr over five classes
};

/// A sequential test, decided on before the first game.
struct SequentialPlan {
  Metric metric = Metric::GoalDifference;
  Hypotheses hypotheses{};
  double alpha = 0.05;
  double beta = 0.05;
  std::int64_t first_look = 8;  ///< [pairs] before it the test does not stop, at least 2
  std::int64_t batch = 1;       ///< [pairs] between looks
  std::int64_t cap = 1000;      ///< [pairs] then it ends undecided
  double clip = 0;              ///< a pair's goal difference counts as at most this much; 0: as it is
};

enum class Decision : std::uint8_t { GoOn, AcceptH0, AcceptH1, Undecided };
const char* name(Decision decision);  ///< "go on", "H0", "H1", "undecided"

/// The test as it stands.
struct SequentialState {
  Decision decision = Decision::GoOn;
  std::int64_t used = 0;  ///< [pairs] at the last look
  double llr = 0;         ///< at the last look
  Bounds bounds{};        ///< tightened, at the last look
};

/// Walks through the scores in the order of the schedule and stops where the test stops: the answer depends
/// on the scores alone, not on when or how often one asks. Scores after the stop are not looked at.
SequentialState sequential_test(std::span<const double> scores, const SequentialPlan& plan);

/// The score as the plan sees it: clipped or not.
double clipped(double score, const SequentialPlan& plan);

/// Expected number of pairs and probability to accept H1 when the true effect is t, for a test without a cap.
///
/// The walk taken as Brownian motion with `expected_llr` and `llr_variance` between the
/// bounds of `wald_bounds`.
///
/// Source  A. Wald, 1945; harness reference 2.2: 5.30 / t1^2 at H0 and H1, 8.67 / t1^2 half way
struct ExpectedCourse {
  double pairs = 0;
  double accept_h1 = 0;
};
ExpectedCourse expected_course(const SequentialPlan& plan, double t);

}  // namespace stats
