#include "sim/world/crossing.h"

#include <gtest/gtest.h>

namespace world {
namespace {

using namespace std::chrono_literals;

TEST(RisingZero, InterpolatesTheInstant) {
  const auto time = rising_zero({Time{0ms}, -1}, {Time{40ms}, 3});
  ASSERT_TRUE(time);
  EXPECT_EQ(*time, Time{10ms});
}

TEST(RisingZero, AZeroOnAFrameBoundaryCountsOnce) {
  EXPECT_TRUE(rising_zero({Time{0ms}, -1}, {Time{10ms}, 0}));
  EXPECT_FALSE(rising_zero({Time{10ms}, 0}, {Time{20ms}, 1}));
}

TEST(RisingZero, FallingOrStayingIsNoEvent) {
  EXPECT_FALSE(rising_zero({Time{0ms}, 1}, {Time{10ms}, -1}));
  EXPECT_FALSE(rising_zero({Time{0ms}, -2}, {Time{10ms}, -1}));
  EXPECT_FALSE(rising_zero({Time{0ms}, 1}, {Time{10ms}, 2}));
}

}  // namespace
}  // namespace world
