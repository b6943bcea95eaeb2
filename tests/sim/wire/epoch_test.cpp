#include "sim/wire/epoch.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>

namespace {

using std::chrono::microseconds;
using wire::Epoch;
using world::Time;

}  // namespace

TEST(Epoch, EveryTickOfAnHourIsExactInSeconds) {
  // Longer than any game: a whole one has at most 40 minutes.
  for (std::int64_t tick = 0; tick < 3600 * world::ticks_per_second; ++tick) {
    for (int substep = 0; substep < world::substeps_per_tick; ++substep) {
      const Time time = world::whole_microseconds(world::tick_time(tick, substep));
      ASSERT_EQ(wire::from_unix_seconds(wire::to_unix_seconds(time, Epoch{}), Epoch{}), time);
    }
  }
}

TEST(Epoch, NeighbouringMicrosecondsStayApart) {
  for (const std::int64_t start : {0LL, 2'399'999'000'000LL}) {
    for (std::int64_t us = start; us < start + 100'000; ++us) {
      const Time time{microseconds{us}};
      ASSERT_EQ(wire::from_unix_seconds(wire::to_unix_seconds(time, Epoch{}), Epoch{}), time);
    }
  }
}

TEST(Epoch, RecordedUnixTimesComeBackToTheBit) {
  // 13 July 2022, as SSL-Vision writes it: a whole number of microseconds, rounded to a double.
  for (std::int64_t us = 1'657'689'247'000'000; us < 1'657'689'247'300'000; ++us) {
    const double recorded = static_cast<double>(us) / 1e6;
    const std::optional<Time> time = wire::from_unix_seconds(recorded, Epoch{});
    ASSERT_TRUE(time.has_value());
    ASSERT_EQ(wire::to_unix_seconds(*time, Epoch{}), recorded);
    ASSERT_EQ(wire::to_microseconds(*time, Epoch{}), us);
  }
}

TEST(Epoch, MatchTimeZeroIsTheEpoch) {
  EXPECT_EQ(wire::to_unix_seconds(Time{}, Epoch{}), 1'700'000'000.0);
  EXPECT_EQ(wire::to_microseconds(Time{}, Epoch{}), 1'700'000'000'000'000);
  EXPECT_EQ(wire::from_microseconds(1'700'000'000'000'001, Epoch{}), Time{microseconds{1}});
  EXPECT_EQ(wire::to_unix_seconds(Time{}, Epoch{.nanoseconds = 0}), 0.0);
}

TEST(Epoch, RoundsLikeTheNounsDo) {
  for (const std::int64_t ns : {499, 500, 501, 1499, 1500, 1501, 2500, -500, -1500}) {
    const Time time{std::chrono::nanoseconds{ns}};
    EXPECT_EQ(wire::from_microseconds(wire::to_microseconds(time, Epoch{}), Epoch{}),
              world::whole_microseconds(time))
        << ns;
  }
}

TEST(Epoch, RefusesWhatIsNoTime) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), infinity, -infinity, -1e-6, 4.1e9, 1e300}) {
    EXPECT_FALSE(wire::from_unix_seconds(bad, Epoch{}).has_value()) << bad;
  }
  EXPECT_TRUE(wire::from_unix_seconds(0.0, Epoch{}).has_value()) << "simulators count from their start";
}
