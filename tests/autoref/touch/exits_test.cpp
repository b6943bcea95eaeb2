#include "tests/autoref/touch/exits.h"

#include <gtest/gtest.h>

namespace study {
namespace {

TEST(Wilson, IsTheKnownInterval) {
  // 8 of 10, 95 %: 0.490 to 0.943 (Newcombe 1998); 132 of 158: 0.770 to 0.885 (requirements 1.6).
  EXPECT_NEAR(wilson(8, 10).low, 0.490, 5e-4);
  EXPECT_NEAR(wilson(8, 10).high, 0.943, 5e-4);
  EXPECT_NEAR(wilson(132, 158).low, 0.770, 5e-4);
  EXPECT_NEAR(wilson(132, 158).high, 0.885, 5e-4);
}

TEST(McNemar, IsTheExactBinomial) {
  EXPECT_NEAR(mcnemar(1, 9), 2 * (1 + 10) / 1024.0, 1e-12);
  EXPECT_NEAR(mcnemar(9, 1), mcnemar(1, 9), 1e-12);
  EXPECT_NEAR(mcnemar(4, 4), 1, 1e-12);
  EXPECT_NEAR(mcnemar(0, 0), 1, 1e-12);
}

TEST(TrueTouches, AreImpulsesAboveOneFiftyMillisecondsApart) {
  constexpr world::RobotId yellow{world::Team::Yellow, 1};
  constexpr world::RobotId blue{world::Team::Blue, 1};
  TrueTouches touches;
  const auto touch = [&](std::int64_t tick, world::RobotId robot, double impulse) {
    truth::Frame frame;
    frame.time = world::tick_time(tick);
    truth::Contact& contact = frame.contacts.emplace_back();
    contact.time = frame.time;
    contact.robot = robot;
    contact.impulse = impulse;
    touches.add(frame);
  };
  touch(1, yellow, 0.0009);
  EXPECT_EQ(touches.last(), nullptr);
  touch(2, yellow, 0.002);
  touch(4, yellow, 0.002);  // 33 ms later: the same one
  EXPECT_EQ(touches.all().size(), 1u);
  touch(8, yellow, 0.002);  // 67 ms later
  EXPECT_EQ(touches.all().size(), 2u);
  EXPECT_EQ(touches.last()->kind(), Kind::Receive);
  touch(9, blue, 0.002);
  EXPECT_EQ(touches.toucher(), blue);
  EXPECT_EQ(touches.last()->kind(), Kind::Squeeze);
}

}  // namespace
}  // namespace study
