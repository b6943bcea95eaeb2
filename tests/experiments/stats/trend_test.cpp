#include "experiments/stats/trend.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "experiments/stats/distributions.h"
#include "experiments/stats/two_samples.h"

namespace stats {
namespace {

TEST(Trend, OfTwoPointsIsTheDifferenceOverTheDistance) {
  const std::vector<double> here = {1, 2, 3, 4};
  const std::vector<double> there = {4, 6, 9, 5, 6};
  const Trend found = trend(std::vector<SweepPoint>{{1, here}, {5, there}});
  const double error = std::hypot(mean_of(here).standard_error, mean_of(there).standard_error);
  EXPECT_NEAR(found.slope, (6 - 2.5) / 4, 1e-12);
  EXPECT_NEAR(found.standard_error, error / 4, 1e-12);
  EXPECT_NEAR(found.p, 2 * normal_cdf(-3.5 / error), 1e-12);
}

// By hand: points (0, 1), (1, 3), (2, 5) with standard errors 1, 1/2, 1: on a line, so the weights do not
// matter for it; weighted sum of squares of x around 1 is 1 + 0 + 1.
TEST(Trend, OfPointsOnALineIsTheLine) {
  const std::vector<double> a = {0, 2};
  const std::vector<double> b = {2.5, 3.5};
  const std::vector<double> c = {4, 6};
  const Trend found = trend(std::vector<SweepPoint>{{0, a}, {1, b}, {2, c}});
  EXPECT_NEAR(found.slope, 2, 1e-12);
  EXPECT_NEAR(found.intercept, 1, 1e-12);
  EXPECT_NEAR(found.standard_error, 1 / std::sqrt(2.0), 1e-12);
}

TEST(Trend, ByPermutationAgreesWithTheExactCount) {
  // Values 1..4 in order at x = 1, 1, 2, 2: of the 6 splits two (the best and its mirror) are as steep.
  const std::vector<double> low = {1, 2};
  const std::vector<double> high = {3, 4};
  const Trend found = trend(std::vector<SweepPoint>{{1, low}, {2, high}});
  // 10 000 draws: three standard deviations of a share of 1/3 are 0.014.
  EXPECT_NEAR(found.permutation_p, 1.0 / 3, 0.014);
}

TEST(Trend, IsUnknownWithOnePoint) {
  const std::vector<double> values = {1, 2, 3};
  EXPECT_FALSE(trend(std::vector<SweepPoint>{{1, values}}).known);
  EXPECT_FALSE(trend(std::vector<SweepPoint>{{1, values}, {1, values}}).known);
  EXPECT_FALSE(trend({}).known);
}

TEST(Trend, BearsPointsWithoutSpread) {
  const std::vector<double> zeros = {0, 0, 0};
  const std::vector<double> ones = {1, 1, 1};
  const std::vector<double> more = {1, 2, 3};
  EXPECT_TRUE(trend(std::vector<SweepPoint>{{0, zeros}, {1, more}}).known);
  // No spread anywhere says nothing of how sure a slope is.
  EXPECT_FALSE(trend(std::vector<SweepPoint>{{0, zeros}, {1, ones}}).known);
}

}  // namespace
}  // namespace stats
