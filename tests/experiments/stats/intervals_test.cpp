#include "experiments/stats/intervals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace stats {
namespace {

// The intervals of the paper's Table 7, first row (reference "harness", 2.5), printed with
// one decimal of a percent.
TEST(Wilson, GivesTheIntervalsOfThePapersTable) {
  const Interval wins = wilson(114, 300);
  EXPECT_NEAR(wins.low * 100, 32.7, 0.05);
  EXPECT_NEAR(wins.high * 100, 43.6, 0.05);
  const Interval losses = wilson(38, 300);
  EXPECT_NEAR(losses.low * 100, 9.4, 0.05);
  EXPECT_NEAR(losses.high * 100, 16.9, 0.05);
}

TEST(Wilson, OfNoSuccessEndsAtZSquaredOverNPlusZSquared) {
  const double z = 1.959963984540054;
  const Interval interval = wilson(0, 10);
  EXPECT_EQ(interval.low, 0);
  EXPECT_NEAR(interval.high, z * z / (10 + z * z), 1e-12);
}

TEST(Wilson, IsMirroredWhenWinsAndLossesAreSwapped) {
  const Interval wins = wilson(3, 20);
  const Interval losses = wilson(17, 20);
  EXPECT_NEAR(wins.low, 1 - losses.high, 1e-15);
  EXPECT_NEAR(wins.high, 1 - losses.low, 1e-15);
}

TEST(Wilson, KnowsNothingWithoutGames) {
  EXPECT_EQ(wilson(0, 0).low, 0);
  EXPECT_EQ(wilson(0, 0).high, 1);
}

TEST(MeanOf, GivesMeanDeviationAndStandardError) {
  // By hand: mean 5, squares 9 1 1 1 0 0 4 16 = 32, deviation sqrt(32/7).
  const std::array<double, 8> values = {2, 4, 4, 4, 5, 5, 7, 9};
  const Mean mean = mean_of(values);
  EXPECT_EQ(mean.count, 8);
  EXPECT_DOUBLE_EQ(mean.mean, 5);
  EXPECT_DOUBLE_EQ(mean.deviation, std::sqrt(32.0 / 7));
  EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(32.0 / 7 / 8));
}

TEST(MeanOf, KnowsNoErrorOfASingleValue) {
  const std::array<double, 1> values = {3};
  EXPECT_EQ(mean_of(values).mean, 3);
  EXPECT_FALSE(mean_of(values).has_error());
}

TEST(TInterval, OfFourValuesUsesThreeDegreesOfFreedom) {
  // Mean 2.5, deviation sqrt(5/3), standard error 0.645497; t = 3.18245 (printed table).
  const std::array<double, 4> values = {1, 2, 3, 4};
  const Interval interval = t_interval(mean_of(values));
  EXPECT_NEAR(interval.low, 2.5 - 3.18245 * 0.6454972, 1e-5);
  EXPECT_NEAR(interval.high, 2.5 + 3.18245 * 0.6454972, 1e-5);
}

TEST(TInterval, OfASingleValueIsEverything) {
  const std::array<double, 1> values = {1};
  EXPECT_TRUE(std::isinf(t_interval(mean_of(values)).high));
}

}  // namespace
}  // namespace stats
