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
  // 12.7062 sqrt(8) sqrt(10 + 100 / 2) / 2, Student's quantile for one degree of freedom from printed tables
  // (four decimals); nothing takes less than no time
  EXPECT_NEAR(left.high - left.seconds, 12.7062 * std::sqrt(8.0) * std::sqrt(60.0) / 2, 0.001);
  EXPECT_EQ(left.low, 0);
}

/// How often of a thousand nights the interval after so many games holds the time of 50 more.
int nights_inside(int games) {
  std::mt19937 random(1);
  std::normal_distribution<double> game(6, 0.5);  // so narrow that no interval is cut at zero
  int inside = 0;
  for (int night = 0; night < 1000; ++night) {
    TimeLeft time;
    for (int i = 0; i < games; ++i) time.add(game(random));
    double truth = 0;
    for (int i = 0; i < 50; ++i) truth += game(random);
    const auto left = *time.estimate(50, 1);
    inside += left.low <= truth && truth <= left.high ? 1 : 0;
  }
  return inside;
}

// 950 of 1000 with a standard deviation of 7; four of them are allowed. With the normal quantile, 3 games
// would give about 810.
TEST(TimeLeft, HoldsTheTruthNineteenTimesInTwentyHoweverFewTheGames) {
  for (const int games : {3, 5, 30}) {
    EXPECT_GT(nights_inside(games), 950 - 28) << games;
    EXPECT_LT(nights_inside(games), 950 + 28) << games;
  }
}

TEST(TimeLeft, NothingLeftTakesNoTime) {
  TimeLeft time;
  time.add(4);
  time.add(8);
  EXPECT_DOUBLE_EQ(time.estimate(0, 2)->high, 0);
}

}  // namespace
}  // namespace runner
