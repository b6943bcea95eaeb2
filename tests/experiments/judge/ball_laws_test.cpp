// The truth's own laws on truth written by hand, of what robots do with the ball: speed, dribbling, second
// touches, kicks.
#include <gtest/gtest.h>

#include "experiments/judge/laws/laws.h"
#include "tests/experiments/judge/story.h"

namespace judge {
namespace {

using world::Location;

// Positions are sums of 1/60 s steps: far below this [m, s, bands].
constexpr double exact = 1e-6;

TEST(BallSpeed, IsTheGreatestBetweenTwoTouches) {
  for (const double speed : {8.4, 7.9, 7.0}) {
    Story story;
    story.ball.position = {-3, 0, Story::radius};
    story.ball.velocity = {speed, 0, 0};
    story.touch(blue(4));
    story.tick(20);
    story.touch(yellow(1));
    story.tick(2);
    const auto fast = story.told(Event::BallTooFast);
    if (speed < 7.6) {  // two bands of 0.2 m/s
      EXPECT_TRUE(fast.empty());
      continue;
    }
    ASSERT_EQ(fast.size(), 1u) << speed;
    EXPECT_NEAR(fast[0].margin, (speed - 8) / 0.2, exact);
    EXPECT_EQ(fast[0].by, blue(4));
  }
}

TEST(BallSpeed, OfAShortFlightCountsByHowMuchFartherTheBallCame) {
  Story story;
  story.ball.position = {-3, 0, Story::radius};
  story.ball.velocity = {9, 0, 0};
  story.touch(blue(4));
  story.tick(7);  // 0.117 s to the next robot
  story.touch(yellow(1));
  story.tick(2);
  const auto fast = story.told(Event::BallTooFast);
  ASSERT_EQ(fast.size(), 1u);
  EXPECT_NEAR(fast[0].margin, 1.0 * 7 * world::tick_length / 0.04, exact);  // the way in bands of 40 mm
}

TEST(BallSpeed, OfTheLastFlightIsToldWhenTheGameEnds) {
  Story story;
  story.ball.velocity = {9, 0, 0};
  story.touch(blue(4));
  story.tick(5);
  EXPECT_TRUE(story.told(Event::BallTooFast).empty());
  story.end();
  EXPECT_EQ(story.told(Event::BallTooFast).size(), 1u);
}

/// Yellow 2 pushes the ball in front of it at 1 m/s; once it is apart [m] from it for some ticks.
std::vector<TrueEvent> dribble(int ticks, int lets_go_at, double apart = 0.03, int apart_for = 1) {
  Story story;
  story.ball.position = {0, 0, Story::radius};
  story.robot(yellow(2), {-0.0945, 0});
  story.touch(yellow(2));
  story.tick();
  story.ball.velocity = {1, 0, 0};
  story.robot(yellow(2)).velocity = {1, 0};
  for (int n = 0; n < ticks; ++n) {
    if (n == lets_go_at) story.ball.position.x() += apart;
    if (n == lets_go_at + apart_for) story.ball.position.x() -= apart;
    story.touch(yellow(2));
    story.tick();
  }
  story.ball.position.x() += 0.1;
  story.tick(2);
  return story.told(Event::DribbledTooFar);
}

TEST(Dribbles, AreMeasuredFromTheFirstContactUntilTheBallIsLetGo) {
  const auto far = dribble(63, -5);  // 1.05 m
  ASSERT_EQ(far.size(), 1u);
  EXPECT_NEAR(far[0].margin, 0.05 / 0.04, exact);
  EXPECT_EQ(far[0].by, yellow(2));
  for (const TrueEvent& event : dribble(63, 30)) EXPECT_FALSE(event.happened());  // it began anew, or nearly
  const auto nearly = dribble(57, -5);                                            // 0.95 m
  ASSERT_EQ(nearly.size(), 1u);
  EXPECT_NEAR(nearly[0].margin, -0.05 / 0.04, exact);
}

TEST(Dribbles, AreCloseWhenOnlyTheSeparationIsInDoubt) {
  for (const int ticks : {66, 59}) {  // 1.1 m; 0.98 m, within a band of the limit
    const auto told = dribble(ticks, 30, 0.04, 2);
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].margin, -0.5);
  }
  EXPECT_TRUE(dribble(56, 30, 0.04, 2).empty());
  // A ball that lies on top of a robot is not dribbled.
  Story rides;
  rides.ball.position = {0, 0, 0.17};
  rides.robot(yellow(2), {0, 0});
  rides.ball.velocity = {1, 0, 0};
  rides.robot(yellow(2)).velocity = {1, 0};
  for (int n = 0; n < 90; ++n) {
    rides.touch(yellow(2));
    rides.tick();
  }
  rides.enter(Location::GameOff);
  rides.tick(60);
  EXPECT_TRUE(rides.told(Event::DribbledTooFar).empty());
}

/// Yellow 1 has kicked a free kick 0.3 m.
Story free_kick() {
  Story story;
  story.enter(Location::Setup);
  story.state.kick_team = world::Team::Yellow;
  story.robot(yellow(1), {-0.0945, 0});
  story.tick(3);
  story.touch(yellow(1));
  story.ball.velocity = {1, 0, 0};
  story.tick(3);
  story.enter(Location::GameOn);
  story.tick(15);
  story.ball.velocity.setZero();
  return story;
}

/// Yellow 1 kicks a free kick 0.3 m and touches it again, if nobody else does before.
Story second_touch(bool other_first) {
  Story story = free_kick();
  if (other_first) story.touch(yellow(2));
  story.tick();
  story.robot(yellow(1)).position.x() += 0.3;
  story.touch(yellow(1));
  story.tick(20);
  return story;
}

TEST(DoubleTouch, IsTheKickersUnlessAnotherRobotTouchedBefore) {
  const Story story = second_touch(false);
  const auto twice = story.told(Event::DoubleTouch);
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_EQ(twice[0].by, yellow(1));
  EXPECT_NEAR(twice[0].value, 0.3, exact);  // 18 ticks at 1 m/s
  EXPECT_TRUE(second_touch(true).told(Event::DoubleTouch).empty());
}

/// After its kick the kicker comes back, up to a gap, and then another robot plays the ball.
std::vector<TrueEvent> back_at_the_ball(double gap) {
  Story story = free_kick();
  story.tick();
  story.robot(yellow(1)).position.x() = story.ball.position.x() - 0.0945 - gap;
  story.tick(30);
  story.touch(blue(1));
  story.tick(30);
  return story.told(Event::DoubleTouch);
}

TEST(DoubleTouch, IsNearlyOneWhenTheKickerComesBackWithoutTouching) {
  const auto nearly = back_at_the_ball(0.05);
  ASSERT_EQ(nearly.size(), 1u);
  EXPECT_NEAR(nearly[0].margin, -0.05 / 0.04, exact);
  EXPECT_EQ(nearly[0].by, yellow(1));
  EXPECT_TRUE(back_at_the_ball(0.081).empty());  // two bands are 0.08 m
}

/// The same second touch, `ticks` after play was stopped.
std::vector<TrueEvent> touch_after_whistle(int ticks) {
  Story story = free_kick();
  if (ticks > 0) story.enter(Location::GameOff);
  story.tick(std::max(ticks, 1));
  story.robot(yellow(1)).position.x() = story.ball.position.x() - 0.1;
  story.touch(yellow(1));
  story.tick(30);
  return story.told(Event::DoubleTouch);
}

TEST(DoubleTouch, IsWatchedForThreeTenthsOfASecondAfterTheWhistleAndIsLate) {
  ASSERT_EQ(touch_after_whistle(0).size(), 1u);
  EXPECT_FALSE(touch_after_whistle(0)[0].late);
  const auto soon = touch_after_whistle(16);  // 0.27 s
  ASSERT_EQ(soon.size(), 1u);
  EXPECT_TRUE(soon[0].late);
  EXPECT_TRUE(touch_after_whistle(20).empty());  // 0.33 s
}

TEST(DoubleTouch, DoesNotCountOnceTheBallWasOut) {
  Story story;
  story.enter(Location::Setup);
  story.state.kick_team = world::Team::Yellow;
  story.ball.position = {0, 2.9, Story::radius};
  story.robot(yellow(1), {-0.0945, 2.9});
  story.tick(3);
  story.touch(yellow(1));
  story.ball.velocity = {0, 2, 0};
  story.tick(2);
  story.enter(Location::GameOn);
  story.tick(10);  // out after 0.06 s; the referee has not said so
  story.touch(yellow(1));
  story.tick(5);
  const auto twice = story.told(Event::DoubleTouch);
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_TRUE(twice[0].late);
}

TEST(KickTaken, IsDatedAtFiftyMillimetres) {
  const Story story = second_touch(false);
  const auto kicks = story.told(Event::KickTaken);
  ASSERT_EQ(kicks.size(), 1u);
  // The ball starts with the fourth tick after the first moment: 1 + 3 ticks, then 50 mm at 1 m/s.
  EXPECT_NEAR(world::seconds(kicks[0].time), 4.0 / 60 + 0.05, exact);
  EXPECT_EQ(kicks[0].by, yellow(1));
}

TEST(KickTaken, NamesWhoWasTooNear) {
  Story story;
  story.enter(Location::Setup);
  story.state.kick_team = world::Team::Yellow;
  story.robot(yellow(1), {-0.0945, 0});
  story.robot(yellow(2), {3.2, 0});  // 0.21 m of hull from the area, 1 m deep in the middle
  story.robot(blue(3), {0, 0.55});   // hull at 0.46 m
  story.robot(blue(4), {0, -0.62});  // at 0.53 m
  story.tick(3);
  story.touch(yellow(1));
  story.tick(1);
  story.robots.erase(story.robots.begin() + 2);  // blue 3 is sent off before the ball has gone 50 mm
  story.ball.velocity = {3, 0, 0};
  story.tick(2);
  story.enter(Location::GameOn);
  story.tick(25);
  const auto near = story.told(Event::OpponentNearBall);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].by, blue(3));
  EXPECT_NEAR(near[0].margin, 0.04 / 0.04, exact);
  const auto attacker = story.told(Event::AttackerNearArea);
  ASSERT_EQ(attacker.size(), 1u);
  EXPECT_NEAR(attacker[0].margin, -0.01 / 0.04, exact);
}

}  // namespace
}  // namespace judge
