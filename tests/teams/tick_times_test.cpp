#include "teams/kit/tick_times.h"

#include <gtest/gtest.h>

namespace kit {
namespace {

TEST(TickTimes, KnowMeanQuantilesAndTheGreatest) {
  TickTimes times;
  for (int i = 1; i <= 100; ++i) times.add(i * 1e-6);
  EXPECT_EQ(times.ticks(), 100);
  EXPECT_NEAR(times.mean(), 50.5e-6, 1e-15);
  // The column of a time ends at most 0.1 us above it.
  EXPECT_NEAR(times.quantile(0.5), 50.05e-6, 0.051e-6);
  EXPECT_NEAR(times.quantile(0.99), 99.05e-6, 0.051e-6);
  EXPECT_DOUBLE_EQ(times.quantile(1), 100e-6);
  EXPECT_DOUBLE_EQ(times.greatest(), 100e-6);
}

TEST(TickTimes, BeyondTheHistogramOnlyTheGreatestIsKnown) {
  TickTimes times;
  times.add(10e-6);
  times.add(2e-3);
  times.add(7e-3);
  EXPECT_NEAR(times.quantile(0.3), 10.05e-6, 0.051e-6);
  EXPECT_DOUBLE_EQ(times.quantile(0.5), 7e-3);
  EXPECT_NEAR(times.mean(), (10e-6 + 9e-3) / 3, 1e-15);
}

TEST(TickTimes, OfNoTicksAreZero) {
  EXPECT_EQ(TickTimes{}.line(), "tick_times ticks=0 mean_us=0.00 median_us=0.0 p99_us=0.0 greatest_us=0.0");
}

TEST(TickTimes, TheThreadsClockGoesOnWhileItComputes) {
  const double begin = thread_seconds();
  while (thread_seconds() == begin) {
  }
  EXPECT_GT(thread_seconds(), begin);
}

}  // namespace
}  // namespace kit
