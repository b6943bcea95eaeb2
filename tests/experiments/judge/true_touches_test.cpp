#include "experiments/judge/true_touches.h"

#include <gtest/gtest.h>

namespace judge {
namespace {

constexpr world::RobotId yellow{world::Team::Yellow, 1};
constexpr world::RobotId blue{world::Team::Blue, 1};

void touch(TrueTouches& touches, std::int64_t tick, world::RobotId robot, double impulse) {
  truth::Frame frame;
  frame.time = world::tick_time(tick);
  truth::Contact& contact = frame.contacts.emplace_back();
  contact.time = frame.time;
  contact.robot = robot;
  contact.impulse = impulse;
  touches.add(frame, true);
}

TEST(TrueTouches, AreImpulsesAboveOneFiftyMillisecondsApart) {
  TrueTouches touches;
  touch(touches, 1, yellow, 0.0009);
  EXPECT_EQ(touches.last_at(world::tick_time(1)), nullptr);
  touch(touches, 2, yellow, 0.002);
  touch(touches, 4, yellow, 0.002);  // 33 ms later: the same one
  EXPECT_EQ(touches.all().size(), 1u);
  touch(touches, 8, yellow, 0.002);  // 67 ms later
  EXPECT_EQ(touches.all().size(), 2u);
  EXPECT_EQ(touches.all().back().kind(), Kind::Receive);
}

TEST(TrueTouches, AreSqueezesWhenTheOtherTeamTouchedWithinATick) {
  TrueTouches touches;
  touch(touches, 8, yellow, 0.002);
  touch(touches, 9, blue, 0.002);
  EXPECT_EQ(touches.all()[0].kind(), Kind::Squeeze);
  EXPECT_EQ(touches.all()[1].kind(), Kind::Squeeze);
  EXPECT_TRUE(touches.ambiguous(*touches.last_at(world::tick_time(9))));
  touch(touches, 11, blue, 0.002);
  EXPECT_FALSE(touches.ambiguous(*touches.last_at(world::tick_time(11))));
}

TEST(TrueTouches, KnowWhoWasLastAtAnyMoment) {
  TrueTouches touches;
  touch(touches, 5, yellow, 0.002);
  touch(touches, 7, blue, 0.002);
  EXPECT_EQ(touches.last_at(world::tick_time(4)), nullptr);
  EXPECT_EQ(touches[touches.last_at(world::tick_time(6))->touch].robot, yellow);
  EXPECT_EQ(touches[touches.last_at(world::tick_time(9))->touch].robot, blue);
}

TEST(Kind, HasItsName) {
  for (std::size_t n = 0; n < kinds; ++n)
    EXPECT_EQ(kind_named(name(static_cast<Kind>(n))), static_cast<Kind>(n));
  EXPECT_EQ(kind_named("caress"), std::nullopt);
}

}  // namespace
}  // namespace judge
