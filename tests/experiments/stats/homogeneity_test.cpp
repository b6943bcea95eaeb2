#include "experiments/stats/homogeneity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "experiments/stats/distributions.h"

namespace stats {
namespace {

TEST(Homogeneity, OfATwoByTwoTableIsAsByHand) {
  // Expected 12, 18, 28, 42, each off by 2: 4/12 + 4/18 + 4/28 + 4/42.
  const Homogeneity found = homogeneity(std::vector<GroupCounts>{{"x", {10, 20}}, {"y", {30, 40}}});
  EXPECT_NEAR(found.chi_square, 4.0 / 12 + 4.0 / 18 + 4.0 / 28 + 4.0 / 42, 1e-12);
  EXPECT_EQ(found.freedom, 1);
  EXPECT_NEAR(found.p, 2 * normal_cdf(-std::sqrt(found.chi_square)), 1e-12) << "one degree is z squared";
  ASSERT_EQ(found.rows.size(), 2U);
  EXPECT_NEAR(found.rows[0].chi_square, found.chi_square, 1e-12) << "of two rows both say the same";
}

TEST(Homogeneity, DropsRowsThatAreTooSmall) {
  const Homogeneity found =
      homogeneity(std::vector<GroupCounts>{{"x", {50, 50}}, {"small", {9, 0}}, {"y", {50, 50}}});
  ASSERT_EQ(found.dropped.size(), 1U);
  EXPECT_EQ(found.dropped[0], "small");
  EXPECT_NEAR(found.chi_square, 0, 1e-12);
  EXPECT_NEAR(found.p, 1, 1e-12);
}

TEST(Homogeneity, SaysNothingWhenThereIsNothingToCompare) {
  EXPECT_EQ(homogeneity({}).freedom, 0);
  EXPECT_EQ(homogeneity(std::vector<GroupCounts>{{"x", {3, 4}}, {"y", {2, 1}}}).freedom, 0);
  EXPECT_EQ(homogeneity(std::vector<GroupCounts>{{"x", {30, 0}}, {"y", {20, 0}}}).freedom, 0);
}

TEST(Homogeneity, FindsTheRowThatStandsOut) {
  const Homogeneity found = homogeneity(
      std::vector<GroupCounts>{{"a", {50, 50}}, {"b", {52, 48}}, {"c", {80, 20}}, {"d", {49, 51}}});
  EXPECT_LT(found.p, 0.001);
  EXPECT_EQ(found.rows[2].name, "c");
  EXPECT_LT(found.rows[2].p, 0.001);
  EXPECT_GT(found.rows[1].p, 0.05);
}

TEST(RunsTest, FindsAlternationAndDrift) {
  std::vector<double> alternating;
  std::vector<double> drifting;
  for (int i = 0; i < 20; ++i) {
    alternating.push_back(i % 2);
    drifting.push_back(i);
  }
  const RunsTest up_and_down = runs_test(alternating);
  EXPECT_EQ(up_and_down.runs, 20);
  EXPECT_DOUBLE_EQ(up_and_down.expected, 11);
  EXPECT_NEAR(up_and_down.z, 9 / std::sqrt(200.0 * 180 / (400 * 19)), 1e-12);
  EXPECT_LT(up_and_down.p, 0.001);
  EXPECT_EQ(runs_test(drifting).runs, 2);
  EXPECT_LT(runs_test(drifting).z, -3);
}

TEST(RunsTest, SaysNothingOfAHandful) {
  EXPECT_EQ(runs_test(std::vector<double>{1, 2, 1, 2}).p, 1);
  EXPECT_EQ(runs_test({}).p, 1);
  EXPECT_EQ(runs_test(std::vector<double>(50, 1.0)).p, 1);
}

TEST(ChiSquareCdf, GivesThePrintedQuantiles) {
  // Printed tables: three decimals; the density there is below 0.1, so 1e-4 covers the last digit.
  EXPECT_NEAR(chi_square_cdf(3.841, 1), 0.95, 1e-4);
  EXPECT_NEAR(chi_square_cdf(5.991, 2), 0.95, 1e-4);
  EXPECT_NEAR(chi_square_cdf(18.307, 10), 0.95, 1e-4);
  EXPECT_NEAR(chi_square_cdf(135.807, 100), 0.99, 1e-4);
}

TEST(ChiSquareCdf, OfTwoDegreesIsExponential) {
  for (const double x : {0.01, 1.0, 4.0, 20.0}) {
    EXPECT_NEAR(chi_square_cdf(x, 2), -std::expm1(-x / 2), 1e-14) << x;
  }
  EXPECT_EQ(chi_square_cdf(0, 3), 0);
}

}  // namespace
}  // namespace stats
