#include "sim/server/pacer.h"

#include <gtest/gtest.h>

namespace {

using server::Pacer;
using namespace std::chrono_literals;

const Pacer::Clock::time_point start{1000s};

}  // namespace

TEST(Pacer, FollowsTheClockTimesTheSpeed) {
  const Pacer real(start, world::Time{}, 1);
  EXPECT_EQ(real.due(world::Time{2s}), start + 2s);
  const Pacer fast(start, world::Time{10s}, 4);
  EXPECT_EQ(fast.due(world::Time{12s}), start + 500ms);
  const Pacer slow(start, world::Time{}, 0.5);
  EXPECT_EQ(slow.due(world::Time{1s}), start + 2s);
}

TEST(Pacer, DoesNotDriftOverADay) {
  const Pacer pacer(start, world::Time{}, 1);
  const world::Time late = world::tick_time(24LL * 3600 * 60);
  EXPECT_EQ(pacer.due(late), start + 24h);  // 8.64e13 ns: far below the 9e15 that a double counts exactly
}

TEST(Pacer, ChangesSpeedWithoutAJump) {
  Pacer pacer(start, world::Time{}, 1);
  pacer.set_speed(start + 1s, world::Time{1010ms}, 2);  // simulated time is 1 s; the next tick 10 ms ahead
  EXPECT_EQ(pacer.due(world::Time{1010ms}), start + 1005ms);
  EXPECT_EQ(pacer.due(world::Time{2s}), start + 1500ms);
}

TEST(Pacer, ATickThatIsLateStaysDueAtOnceAfterAChange) {
  Pacer pacer(start, world::Time{}, 1);
  pacer.set_speed(start + 1s, world::Time{900ms}, 10);  // 100 ms behind
  EXPECT_EQ(pacer.due(world::Time{900ms}), start + 1s) << "and what is behind is not caught up with";
}

TEST(Pacer, StandsStillInAPause) {
  Pacer pacer(start, world::Time{}, 1);
  pacer.set_speed(start + 1s, world::Time{1010ms}, 0);
  EXPECT_EQ(pacer.due(world::Time{1010ms}), Pacer::Clock::time_point::max());
  EXPECT_EQ(pacer.give_up(start + 1h, world::Time{1010ms}), Pacer::Clock::duration::zero());
  pacer.set_speed(start + 1h, world::Time{1010ms}, 1);
  EXPECT_EQ(pacer.due(world::Time{1010ms}), start + 1h + 10ms) << "the hour did not count";
}

TEST(Pacer, CatchesUpWithATenthOfASecondOnly) {
  Pacer pacer(start, world::Time{}, 1);
  EXPECT_EQ(pacer.give_up(start + 100ms, world::Time{}), 0ms);
  EXPECT_EQ(pacer.due(world::Time{}), start);
  EXPECT_EQ(pacer.give_up(start + 350ms, world::Time{}), 250ms);
  EXPECT_EQ(pacer.due(world::Time{}), start + 250ms);
  EXPECT_EQ(pacer.due(world::Time{1s}), start + 1250ms);
}
