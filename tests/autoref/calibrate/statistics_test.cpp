#include "autoref/calibrate/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "autoref/calibrate/noise.h"
#include "sim/world/random.h"

namespace calibrate {
namespace {

TEST(Quantile, InterpolatesBetweenOrderStatistics) {
  std::vector<double> values = {4, 1, 3, 2, 5};
  EXPECT_EQ(quantile(values, 0), 1);
  EXPECT_EQ(quantile(values, 1), 5);
  EXPECT_EQ(median(values), 3);
  EXPECT_DOUBLE_EQ(quantile(values, 0.625), 3.5);
}

TEST(Spread, IsTheStandardDeviationOfGaussians) {
  world::RandomStream random(1, "spread");
  std::vector<double> values(20000);
  for (double& value : values) value = 3 * random.gaussian();
  const Estimate found = spread(values);
  EXPECT_NEAR(found.value, 3, 4 * found.error);
  EXPECT_NEAR(found.error, 3 * 1.166 / std::sqrt(20000.0), 0.001);
}

// A tenth of wild values moves the 50 % point of the others to their 55.6 % point: from 0.674 to 0.765 sigma.
TEST(Spread, HardlyMindsWildValues) {
  world::RandomStream random(2, "spread");
  std::vector<double> values(20000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 10 == 0 ? 1000 : random.gaussian();
  EXPECT_NEAR(spread(values).value, 0.765 / 0.674, 0.04);  // 4 standard errors
}

// Of uniform values the p quantile has the standard deviation sqrt(p (1 - p) / n).
TEST(HighQuantile, HasTheErrorOfOrderStatistics) {
  std::vector<double> values(1001);
  std::iota(values.begin(), values.end(), 0.0);
  for (double& value : values) value /= 1000;
  const Estimate found = high_quantile(values, 0.9, 1);
  EXPECT_NEAR(found.value, 0.9, 1e-12);
  EXPECT_NEAR(found.error, std::sqrt(0.9 * 0.1 / 1001), 1e-9);
}

TEST(Combined, WeighsByTheErrorsAndLeavesOutTheWild) {
  const Estimate two = combined({{1, 1, 1}, {2, 0.5, 1}});
  EXPECT_DOUBLE_EQ(two.value, (1 * 1 + 2 * 4) / 5.0);
  EXPECT_DOUBLE_EQ(two.error, std::sqrt(1 / 5.0));
  const Estimate three = combined({{1, 0.1, 1}, {1, 0.1, 1}, {50, 0.1, 1}});
  EXPECT_DOUBLE_EQ(three.value, 1);
  EXPECT_EQ(three.samples, 2U);
  // chi^2 of 8 for one degree of freedom: the error grows by sqrt(8), to 0.2.
  const Estimate apart = combined({{0.2, 0.1, 1}, {-0.2, 0.1, 1}});
  EXPECT_NEAR(apart.error, 0.2, 1e-12);
}

TEST(ThirdDifference, DoesNotSeeAParabolaAtAnyTimes) {
  const std::array<double, 4> times = {0, 0.013, 0.041, 0.052};
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) values[i] = 3 - 2 * times[i] + 40 * times[i] * times[i];
  EXPECT_NEAR(third_difference(times, values), 0, 1e-12);  // rounding of 1e5 times 1e-16
}

TEST(ThirdDifference, OfEvenTimesIsOneThreeThreeOne) {
  const double found = third_difference({0, 1, 2, 3}, {5, 1, 7, -2});
  EXPECT_NEAR(found, (-5 + 3 * 1 - 3 * 7 - 2) / std::sqrt(20.0), 1e-12);
}

}  // namespace
}  // namespace calibrate
