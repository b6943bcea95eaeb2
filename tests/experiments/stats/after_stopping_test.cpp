#include "experiments/stats/after_stopping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/stats/distributions.h"
#include "experiments/stats/random.h"

namespace stats {
namespace {

// Closed form: P(the lower end is ever reached), the gambler's ruin of Brownian motion.
TEST(AbsorbedBelow, IsTheGamblersRuinInTheEnd) {
  const double low = -2;
  const double high = 3;
  for (const double drift : {-1.0, -0.2, 0.3, 2.0}) {
    const double h = -2 * drift / 1.5;
    const double exact = (std::exp(h * high) - 1) / (std::exp(h * high) - std::exp(h * low));
    EXPECT_NEAR(absorbed_below(low, high, drift, 1.5, 400), exact, 1e-9) << drift;
  }
  EXPECT_NEAR(absorbed_below(low, high, 0, 1.5, 400), 3.0 / 5, 1e-9);
}

// A second method: the eigenfunction series of the same probability.
TEST(AbsorbedBelow, AgreesWithTheEigenfunctionSeries) {
  const double low = -2.9;
  const double high = 2.2;
  const double width = high - low;
  const double variance = 0.7;
  for (const double drift : {-0.8, 0.0, 0.25}) {
    for (const double time : {2.0, 8.0, 40.0}) {
      const double x = -low;
      const double ever =
          drift == 0 ? high / width
                     : (std::exp(-2 * drift * high / variance) - 1) /
                           (std::exp(-2 * drift * high / variance) - std::exp(-2 * drift * low / variance));
      double later = 0;
      for (int n = 1; n < 200; ++n) {
        const double k = n * std::numbers::pi / width;
        const double rate = drift * drift / (2 * variance) + k * k * variance / 2;
        later += k * variance / width * std::sin(k * x) * std::exp(-rate * time) / rate;
      }
      later *= std::exp(drift * low / variance);
      EXPECT_NEAR(absorbed_below(low, high, drift, variance, time), ever - later, 1e-9)
          << drift << " " << time;
    }
  }
}

TEST(AbsorbedBelow, IsTheOneSidedFormulaWhenTheOtherEndIsFar) {
  // Reflection principle: 2 P(X < low) without drift.
  EXPECT_NEAR(absorbed_below(-1, 50, 0, 1, 2), 2 * normal_cdf(-1 / std::sqrt(2.0)), 1e-12);
}

TEST(InsideBelow, AndTheTwoEndsMakeOne) {
  for (const double drift : {-0.5, 0.0, 0.1, 3.0}) {
    for (const double time : {0.1, 1.0, 20.0}) {
      const double sum = absorbed_below(-2, 3, drift, 1, time) + absorbed_below(-3, 2, -drift, 1, time) +
                         inside_below(-2, 3, drift, 1, time, 3);
      EXPECT_NEAR(sum, 1, 1e-9) << drift << " " << time;
    }
  }
}

TEST(AfterStopping, IsThePlainMeanAtTheFirstLook) {
  // Nothing has been looked at before, so there is nothing to correct.
  SequentialPlan plan;
  plan.hypotheses = {0, 0.4};
  const double t = 1.7;
  const SequentialState state{Decision::AcceptH1, 8, 8 * expected_llr(t, plan.hypotheses),
                              wald_bounds(0.05, 0.05)};
  const Estimate estimate = after_stopping(state, plan);
  EXPECT_NEAR(estimate.value, t, 1e-9);
  // Its ends are those of the plain normal test: l(t) (n) off by 1.96 deviations.
  for (const double end : {estimate.interval.low, estimate.interval.high}) {
    const double off = (state.llr - 8 * expected_llr(end, plan.hypotheses)) /
                       std::sqrt(8 * llr_variance(end, plan.hypotheses));
    EXPECT_NEAR(std::abs(off), 1.959964, 1e-5);
  }
}

TEST(AfterStopping, IsMirroredWhenTheOutcomeIs) {
  SequentialPlan plan;
  plan.hypotheses = {-0.2, 0.2};
  const Bounds bounds = wald_bounds(0.05, 0.05);
  const Estimate up = after_stopping({Decision::AcceptH1, 40, bounds.upper, bounds}, plan);
  const Estimate down = after_stopping({Decision::AcceptH0, 40, bounds.lower, bounds}, plan);
  EXPECT_NEAR(up.value, -down.value, 1e-6);
  EXPECT_NEAR(up.interval.low, -down.interval.high, 1e-6);
}

TEST(AfterStopping, PullsAnEarlySuccessTowardsZero) {
  SequentialPlan plan;
  plan.hypotheses = {0, 0.2};
  const Bounds bounds = wald_bounds(0.05, 0.05);
  const std::int64_t n = 60;
  const double naive = bounds.upper / (static_cast<double>(n) * 0.2) + 0.1;
  const Estimate estimate = after_stopping({Decision::AcceptH1, n, bounds.upper, bounds}, plan);
  EXPECT_LT(estimate.value, naive);
  EXPECT_GT(estimate.value, 0);
}

TEST(AfterStopping, WorksWithH1OnTheOtherSide) {
  SequentialPlan plan;
  plan.hypotheses = {0, -0.2};
  const Bounds bounds = wald_bounds(0.05, 0.05);
  const Estimate estimate = after_stopping({Decision::AcceptH1, 60, bounds.upper, bounds}, plan);
  EXPECT_LT(estimate.value, 0);
  EXPECT_LT(estimate.interval.low, estimate.value);
  EXPECT_GT(estimate.interval.high, estimate.value);
}

// The claim itself: for the true t the outcome's probability is uniform, so the value is as often too high as
// too low and the interval covers as often as it says. 600 tests a case, fixed seed: three standard
// deviations are 0.061 at 1/2 and 0.027 at 0.95; 0.02 more for steps being no Brownian motion.
TEST(AfterStopping, IsTooHighAsOftenAsTooLow) {
  SequentialPlan plan;
  plan.hypotheses = {0, 0.2};
  plan.cap = 300;
  Random random(11);
  constexpr int tests = 600;
  for (const double t : {0.0, 0.1, 0.2, 0.35}) {
    int low = 0;
    int covered = 0;
    for (int i = 0; i < tests; ++i) {
      std::vector<double> scores(static_cast<std::size_t>(plan.cap));
      for (double& score : scores) {
        score = t + normal_quantile(random.uniform() * (1 - 2e-12) + 1e-12);
      }
      const double p = outcome_probability(sequential_test(scores, plan), plan, t);
      low += p < 0.5 ? 1 : 0;
      covered += p > 0.025 && p < 0.975 ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(low) / tests, 0.5, 0.081) << t;
    EXPECT_NEAR(static_cast<double>(covered) / tests, 0.95, 0.047) << t;
  }
}

}  // namespace
}  // namespace stats
