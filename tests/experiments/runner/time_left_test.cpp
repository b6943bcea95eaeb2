#include "experiments/runner/time_left.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace runner {
namespace {

TEST(TimeLeft, IsUnknownBeforeTheSecondGame) {
  TimeLeft time;
  EXPECT_FALSE(time.estimate(10, 2));
  time.add(3);
  EXPECT_FALSE(time.estimate(10, 2));
  time.add(3);
  EXPECT_TRUE(time.estimate(10, 2));
}

TEST(TimeLeft, EqualGamesLeaveNoDoubt) {
  TimeLeft time;
  for (int i = 0; i < 5; ++i) time.add(6);
  const auto left = *time.estimate(100, 4);
  EXPECT_DOUBLE_EQ(left.seconds, 150);  // 100 games of 6 s, four at a time
  EXPECT_DOUBLE_EQ(left.low, 150);
  EXPECT_DOUBLE_EQ(left.high, 150);
}

TEST(TimeLeft, FollowsItsFormula) {
  TimeLeft time;
  for (const double seconds : {4.0, 8.0}) time.add(seconds);  // mean 6, deviation sqrt(8)
  const auto left = *time.estimate(10, 2);
  EXPECT_DOUBLE_EQ(left.seconds, 30);
  // 1.96 sqrt(8) sqrt(10 + 100 / 2) / 2; equal up to rounding
  EXPECT_NEAR(left.high - left.seconds, 1.96 * std::sqrt(8.0) * std::sqrt(60.0) / 2, 1e-12);
  EXPECT_NEAR(left.low, 30 - (left.high - 30), 1e-12);
}

TEST(TimeLeft, HoldsTheTruthAboutNineteenTimesInTwenty) {
  std::mt19937 random(1);
  std::normal_distribution<double> game(6, 2);
  int inside = 0;
  for (int night = 0; night < 1000; ++night) {
    TimeLeft time;
    for (int i = 0; i < 30; ++i) time.add(game(random));
    double truth = 0;
    for (int i = 0; i < 50; ++i) truth += game(random);
    const auto left = *time.estimate(50, 1);
    inside += left.low <= truth && truth <= left.high ? 1 : 0;
  }
  // 950 of 1000 with a standard deviation of 7; a little less, since the deviation is estimated from 30 games
  // (normal instead of t: 94.1 %). Four deviations.
  EXPECT_GT(inside, 941 - 30);
  EXPECT_LT(inside, 950 + 28);
}

TEST(TimeLeft, NothingLeftTakesNoTime) {
  TimeLeft time;
  time.add(4);
  time.add(8);
  EXPECT_DOUBLE_EQ(time.estimate(0, 2)->high, 0);
}

}  // namespace
}  // namespace runner
