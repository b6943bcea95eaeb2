#include "experiments/stopping/estimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "experiments/stats/after_stopping.h"

namespace stopping {
namespace {

stats::SequentialPlan plan_of(double t1, std::int64_t cap = 400) {
  stats::SequentialPlan plan;
  plan.hypotheses = {0, t1};
  plan.batch = 4;
  plan.cap = cap;
  return plan;
}

TEST(CorrectedEffect, IsTheOneSeenWhenTheTestCouldNotStopEarly) {
  // A first look at the cap: an ordinary sample of 100. The median of t-hat differs from t by less than 1 %.
  stats::SequentialPlan plan = plan_of(0.3, 100);
  plan.first_look = 100;
  const stats::Estimate estimate = corrected_effect(0.5, 100, plan);
  const double error = std::sqrt((1 + 0.5 * 0.5 / 2) / 100);
  EXPECT_NEAR(estimate.value, 0.5,
              0.2 * error);  // five errors of a median of 1000 runs: 5 * 1.25 / sqrt(1000)
  EXPECT_NEAR(estimate.interval.low, 0.5 - 1.96 * error, 0.4 * error);  // five errors of a tail of 1000 runs
  EXPECT_NEAR(estimate.interval.high, 0.5 + 1.96 * error, 0.4 * error);
}

TEST(CorrectedEffect, IsNearerToZeroThanTheOneSeenWhenATestStoppedBecauseOfIt) {
  const stats::SequentialPlan plan = plan_of(0.3);
  EXPECT_LT(corrected_effect(0.6, 28, plan).value, 0.6);
  EXPECT_GT(corrected_effect(0.6, 28, plan).value, 0.2);
}

TEST(CorrectedEffect, OfAHugeEffectIsAboutTheOneSeen) {
  const stats::Estimate estimate = corrected_effect(4.8, 12, plan_of(0.28, 40));
  EXPECT_GT(estimate.value, 3.5);
  EXPECT_GT(estimate.interval.high, 4.8);
}

TEST(CorrectedEffect, IsRightHalfTheTimeAndCoversNineteenOfTwenty) {
  const stats::SequentialPlan plan = plan_of(0.4, 100);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr int tests = 150;
  for (const double truth : {0.0, 0.4, 1.5}) {
    int above = 0;
    int covered = 0;
    for (int test = 0; test < tests; ++test) {
      std::vector<double> scores(100);
      std::generate(scores.begin(), scores.end(), [&] { return truth + normal(random); });
      const stats::SequentialState state = stats::sequential_test(scores, plan);
      const stats::Mean mean = stats::mean_of(std::span(scores).first(static_cast<std::size_t>(state.used)));
      const stats::Estimate estimate =
          corrected_effect(mean.mean / mean.deviation, static_cast<int>(state.used), plan, 200);
      above += estimate.value > truth;
      covered += estimate.interval.low <= truth && truth <= estimate.interval.high;
    }
    // Four deviations of a binomial number: 4 sqrt(150 / 4) = 24, and 4 sqrt(150 * .05 * .95) = 11. 200 runs
    // make the ends of the interval less sure, hence a twentieth less coverage allowed than that.
    EXPECT_NEAR(above, tests / 2, 24) << truth;
    EXPECT_GE(covered, 0.95 * tests - 11 - 7) << truth;
  }
}

TEST(CorrectedEffect, AgreesWithTheFormulaForSmallEffects) {
  // Another order of outcomes and Brownian motion instead of play: they must agree within half an error.
  const stats::SequentialPlan plan = plan_of(0.15, 1000);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int test = 0; test < 4; ++test) {
    std::vector<double> scores(1000);
    std::generate(scores.begin(), scores.end(), [&] { return 0.1 + normal(random); });
    const stats::SequentialState state = stats::sequential_test(scores, plan);
    const stats::Mean mean = stats::mean_of(std::span(scores).first(static_cast<std::size_t>(state.used)));
    const stats::Estimate played =
        corrected_effect(mean.mean / mean.deviation, static_cast<int>(state.used), plan, 300);
    const stats::Estimate formula = stats::after_stopping(state, plan);
    EXPECT_NEAR(played.value, formula.value, 0.6 / std::sqrt(static_cast<double>(state.used))) << state.used;
  }
}

}  // namespace
}  // namespace stopping
