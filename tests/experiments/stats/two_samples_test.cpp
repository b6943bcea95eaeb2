#include "experiments/stats/two_samples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace stats {
namespace {

// R. G. Newcombe 1998, Table II, method 10, printed with four decimals.
TEST(Newcombe, GivesThePublishedIntervals) {
  const Interval first = newcombe(56, 70, 48, 80);
  EXPECT_NEAR(first.low, 0.0524, 5e-5);
  EXPECT_NEAR(first.high, 0.3339, 5e-5);
  const Interval second = newcombe(9, 10, 3, 10);
  EXPECT_NEAR(second.low, 0.1705, 5e-5);
  EXPECT_NEAR(second.high, 0.8090, 5e-5);
  const Interval third = newcombe(5, 56, 0, 29);
  EXPECT_NEAR(third.low, -0.0381, 5e-5);
  EXPECT_NEAR(third.high, 0.1926, 5e-5);
}

TEST(Newcombe, KnowsNothingWithoutGames) { EXPECT_EQ(newcombe(0, 0, 3, 5).high, 1); }

// Student's data of 1908 (two sleeping drugs), as R's t.test prints them.
constexpr std::array<double, 10> drug1 = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
constexpr std::array<double, 10> drug2 = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

TEST(Welch, GivesThePublishedTestOfStudentsData) {
  const TTest test = welch(mean_of(drug1), mean_of(drug2));
  EXPECT_NEAR(test.t, -1.8608, 5e-5);
  EXPECT_NEAR(test.freedom, 17.776, 5e-4);
  EXPECT_NEAR(test.p, 0.07939, 5e-6);
  EXPECT_NEAR(test.interval.low, -3.3654832, 5e-7);
  EXPECT_NEAR(test.interval.high, 0.2054832, 5e-7);
}

TEST(TTest, GivesThePublishedPairedTestOfStudentsData) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < drug1.size(); ++i) differences.push_back(drug1[i] - drug2[i]);
  const TTest test = t_test(mean_of(differences));
  EXPECT_NEAR(test.t, -4.0621, 5e-5);
  EXPECT_NEAR(test.p, 0.002833, 5e-7);
  EXPECT_NEAR(test.interval.low, -2.4598858, 5e-7);
  EXPECT_NEAR(test.interval.high, -0.7001142, 5e-7);
}

// Equal values show no spread, and without a spread nothing says how far the next value may be.
TEST(TTest, SaysNothingOfOneValueAndNothingOfEqualOnes) {
  EXPECT_EQ(t_test(mean_of(std::array{3.0})).p, 1);
  for (const TTest& equal :
       {t_test(mean_of(std::array{3.0, 3.0})), t_test(mean_of(std::array{0.1, 0.1, 0.1}))}) {
    EXPECT_FALSE(equal.known);
    EXPECT_EQ(equal.p, 1);
    EXPECT_TRUE(std::isinf(equal.interval.low) && std::isinf(equal.interval.high));
  }
  EXPECT_TRUE(t_test(mean_of(std::array{3.0, 3.1})).known);
  EXPECT_EQ(t_test(mean_of(std::array{0.0, 0.0})).p, 1);
  EXPECT_EQ(welch(mean_of(drug1), mean_of(std::array{3.0})).p, 1);
}

}  // namespace
}  // namespace stats
