#include "sim/world/time.h"

#include <gtest/gtest.h>

namespace world {
namespace {

using namespace std::chrono_literals;

TEST(TickTime, IsTheNearestNanosecondToTheExactSixtieth) {
  EXPECT_EQ(tick_time(0), Time{});
  EXPECT_EQ(tick_time(1), Time{16'666'667ns});  // 16 666 666.67
  EXPECT_EQ(tick_time(2), Time{33'333'333ns});  // 33 333 333.33
  EXPECT_EQ(tick_time(3), Time{50ms});
}

TEST(TickTime, DoesNotDriftOverADay) { EXPECT_EQ(tick_time(24 * 3600 * 60), Time{24h}); }

TEST(TickTime, SubstepsSplitATickIntoFour) {
  EXPECT_EQ(tick_time(0, 1), Time{4'166'667ns});
  EXPECT_EQ(tick_time(5, 4), tick_time(6));
  EXPECT_EQ(tick_time(5, 0), tick_time(5));
}

TEST(FromSeconds, RoundsToTheNearestNanosecondOnBothSidesOfZero) {
  EXPECT_EQ(from_seconds(1.5), 1500ms);
  EXPECT_EQ(from_seconds(-1.5), -1500ms);
  EXPECT_EQ(from_seconds(0.6e-9), 1ns);
  EXPECT_EQ(from_seconds(-0.6e-9), -1ns);
}

TEST(WholeMicroseconds, RoundsAndKeepsWhatIsWhole) {
  EXPECT_EQ(whole_microseconds(Time{16'666'667ns}), Time{16'667us});
  EXPECT_EQ(whole_microseconds(Time{50ms}), Time{50ms});
}

}  // namespace
}  // namespace world
