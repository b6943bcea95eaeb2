#include "experiments/stats/resampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "experiments/stats/distributions.h"

namespace stats {
namespace {

// Darwin's maize, the first randomisation test: Fisher counted 863 of 32768 arrangements with a sum of 314 or
// more ("The Design of Experiments", Sec. 21), so twice that for both sides.
TEST(SignFlip, GivesFishersCountForDarwinsMaize) {
  const std::array<double, 15> differences = {49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
  EXPECT_DOUBLE_EQ(sign_flip(differences), 2 * 863.0 / 32768);
}

TEST(SignFlip, LeavesZerosOut) {
  EXPECT_DOUBLE_EQ(sign_flip(std::array{1.0, 0.0, 1.0, 0.0, 1.0}), 2.0 / 8);
  EXPECT_EQ(sign_flip(std::array{0.0, 0.0}), 1);
  EXPECT_EQ(sign_flip({}), 1);
}

// Beyond 20 values random patterns: 30 equal ones make it a binomial test, which is known exactly.
TEST(SignFlip, DrawsPatternsWhenThereAreTooManyToCount) {
  std::vector<double> values(30, 1.0);
  for (std::size_t i = 0; i < 10; ++i) values[i] = -1;
  const double exact = 2 * incomplete_beta(0.5, 20, 11);  // P(20 or more of 30) twice, 0.0987
  EXPECT_NEAR(sign_flip(values), exact, 3 * std::sqrt(exact / 100'000));
}

TEST(SignFlip, IsNeverZero) {
  const std::vector<double> values(40, 1.0);
  EXPECT_DOUBLE_EQ(sign_flip(values), 1.0 / 100'001);
}

// The mean of samples of ten zeros and ten ones is binomial: its quantiles are 6/20 and 14/20 (tails 0.021
// beyond, 0.058 with them, far from 0.025 for 10 000 draws).
TEST(Bootstrap, GivesTheBinomialQuantilesForZerosAndOnes) {
  std::vector<double> values(20, 0.0);
  for (std::size_t i = 0; i < 10; ++i) values[i] = 1;
  const Interval interval = bootstrap(values);
  EXPECT_DOUBLE_EQ(interval.low, 0.3);
  EXPECT_DOUBLE_EQ(interval.high, 0.7);
}

TEST(Bootstrap, IsTheSameEveryTime) {
  const std::array<double, 6> values = {1, 2, 4, 8, 16, 32};
  EXPECT_EQ(bootstrap(values).low, bootstrap(values).low);
}

TEST(Bootstrap, SaysNothingOfFewValuesAndNothingOfEqualOnes) {
  EXPECT_TRUE(std::isinf(bootstrap(std::array{1.0}).high));
  EXPECT_TRUE(std::isinf(bootstrap(std::array{1.0, 2.0, 4.0, 8.0, 16.0}).high));
  EXPECT_TRUE(std::isinf(bootstrap(std::array{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}).high));
}

// A second method: for many values the normal interval.
TEST(Bootstrap, ApproachesTheNormalInterval) {
  std::vector<double> values;
  for (int i = 0; i < 400; ++i) values.push_back(std::fmod(i * 0.6180339887, 1.0));
  const Mean mean = mean_of(values);
  const Interval interval = bootstrap(values);
  // The ends' own random error: 1.96 SE has a relative error of about 2 % with 10 000 draws.
  EXPECT_NEAR(interval.low, mean.mean - 1.96 * mean.standard_error, 0.1 * mean.standard_error);
  EXPECT_NEAR(interval.high, mean.mean + 1.96 * mean.standard_error, 0.1 * mean.standard_error);
}

}  // namespace
}  // namespace stats
