#include "experiments/bench/team_times.h"

#include <gtest/gtest.h>

namespace bench {
namespace {

TEST(TeamTimes, AreReadFromTheLastLineOfThatName) {
  const auto times = team_times(
      "passes 12\n"
      "tick_times ticks=1 mean_us=1 median_us=2 p99_us=3 greatest_us=4\n"
      "tick_times ticks=3600 mean_us=12.31 median_us=11.8 p99_us=30.1 greatest_us=95.0\n"
      "goodbye\n");
  ASSERT_TRUE(times);
  EXPECT_DOUBLE_EQ(times->median, 11.8e-6);
  EXPECT_DOUBLE_EQ(times->ninety_nine, 30.1e-6);
}

TEST(TeamTimes, AreNothingWhereTheTeamSaysNothingOfThem) {
  EXPECT_FALSE(team_times(""));
  EXPECT_FALSE(team_times("a tick_times median_us=1 p99_us=2\n"));
  EXPECT_FALSE(team_times("tick_times median_us=1\n"));
  EXPECT_FALSE(team_times("tick_times median_us=one p99_us=2\n"));
}

}  // namespace
}  // namespace bench
