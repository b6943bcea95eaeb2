// The truth's own laws on truth written by hand: exact places, times and margins.
#include "experiments/judge/laws/laws.h"

#include <gtest/gtest.h>

#include "tests/experiments/judge/story.h"

namespace judge {
namespace {

using world::Location;

// Positions are sums of 1/60 s steps: far below this [m, s, bands].
constexpr double exact = 1e-6;

/// A ball that yellow 1 kicked rolls over a touch line at 2 m/s.
TrueEvent rolls_out(Story& story) {
  story.ball.position = {1, 2.5, Story::radius};
  story.ball.velocity = {0, 2, 0};
  story.touch(yellow(1));
  story.tick(60);
  const auto exits = story.told(Event::Exit);
  EXPECT_EQ(exits.size(), 1u);
  return exits.at(0);
}

TEST(Exits, AreDatedWhereTheWholeBallIsOutside) {
  Story story;
  const double begin = story.now();
  const TrueEvent exit = rolls_out(story);
  EXPECT_NEAR(world::seconds(exit.time), begin + (3 + Story::radius - 2.5) / 2, exact);
  EXPECT_NEAR(exit.place.y(), 3 + Story::radius, exact);
  EXPECT_EQ(exit.last->robot, yellow(1));
  EXPECT_EQ(exit.by, yellow(1));
  EXPECT_FALSE(exit.ambiguous);
  // Half a second later it is 1 m outside, within a tick's way of 33 mm.
  EXPECT_NEAR(exit.margin, 1.0 / 0.04, 0.034 / 0.04);
}

TEST(Exits, AreTheSameAtTheOtherEnd) {
  Story here;
  Story there(true);
  const TrueEvent one = rolls_out(here);
  const TrueEvent other = rolls_out(there);
  EXPECT_EQ(one.time, other.time);
  EXPECT_NEAR(one.margin, other.margin, exact);
  EXPECT_NEAR((one.place + other.place).norm(), 0, exact);
}

TEST(Exits, NeedTheWholeBall) {
  Story story;
  story.ball.position = {1, 3 + Story::radius - 0.001, Story::radius};
  story.touch(yellow(1));
  story.tick(30);
  story.ball.velocity = {0, -1, 0};
  story.tick(30);
  const auto exits = story.told(Event::Exit);
  ASSERT_EQ(exits.size(), 1u);
  EXPECT_FALSE(exits[0].happened());
  EXPECT_NEAR(exits[0].margin, -0.001 / 0.04, exact);
}

TEST(Exits, AreAmbiguousWhenBothTeamsTouchedWithinATick) {
  for (const int ticks_between : {0, 1, 3}) {
    Story story;
    story.ball.position = {1, 2.5, Story::radius};
    story.ball.velocity = {0, 2, 0};
    story.touch(blue(2), 0.01, 4);
    story.tick(ticks_between > 0 ? ticks_between : 1);
    story.touch(yellow(1), 0.01, 4);
    if (ticks_between == 0) story.touch(blue(2), 0.002, 4);
    story.tick(60);
    const auto exits = story.told(Event::Exit);
    ASSERT_EQ(exits.size(), 1u);
    EXPECT_EQ(exits[0].last->robot, yellow(1)) << "the harder touch of one moment counts";
    EXPECT_EQ(exits[0].ambiguous, ticks_between <= 1) << ticks_between;
  }
}

TEST(Exits, EndPlayUntilItIsRestartedUnlessTheyWereClose) {
  for (const double depth : {0.02, 0.1}) {  // half a band, two and a half
    Story story;
    story.ball.position = {1, 3 + Story::radius + depth, Story::radius};
    story.touch(yellow(1));
    story.tick(2);
    for (int n = 0; n < 2; ++n) {
      story.ball.position.y() = 2.9;
      story.tick(3);
      story.ball.position.y() = 3 + Story::radius + depth;
      story.tick(3);
    }
    story.ball.position.y() = 2.9;
    story.tick(3);
    EXPECT_EQ(story.told(Event::Exit).size(), depth < 0.04 ? 3u : 1u) << depth;
  }
}

TEST(Exits, GoOnForAMomentAfterTheWhistleAndAreLate) {
  Story story;
  story.ball.position = {1, 2.98, Story::radius};
  story.ball.velocity = {0, 1, 0};
  story.touch(yellow(1));
  story.tick(1);
  story.enter(Location::GameOff);  // 25 ms too early
  story.tick(60);
  const auto exits = story.told(Event::Exit);
  ASSERT_EQ(exits.size(), 1u);
  EXPECT_TRUE(exits[0].late);
}

/// Shoots at blue's goal from 1 m, from height `z` on.
std::vector<TrueEvent> shot(double y, double z, Event event, bool mirrored = false) {
  Story story(mirrored);
  story.ball.position = {3.5, y, z};
  story.ball.velocity = {4, 0, 0};
  story.touch(yellow(3));
  story.tick(19);  // 1.27 m: 0.25 m behind the line
  story.ball.velocity.setZero();
  story.tick(40);
  return story.told(event);
}

TEST(Goals, AreBetweenThePostsAndUnderTheBar) {
  for (const bool mirrored : {false, true}) {
    EXPECT_EQ(shot(0.4, Story::radius, Event::Goal, mirrored).size(), 1u);
    EXPECT_TRUE(shot(0.6, Story::radius, Event::Goal, mirrored).empty());
    EXPECT_EQ(shot(0.6, Story::radius, Event::Exit, mirrored).size(), 1u);
    const auto over = shot(0.4, 0.3, Event::Exit, mirrored);
    ASSERT_EQ(over.size(), 1u);
    EXPECT_TRUE(over[0].over_goal);
    EXPECT_TRUE(over[0].last->chip);
  }
}

TEST(Goals, AreAlmostChipsWhenTheBallWasNearlyTooHigh) {
  // Tops at 141.5 mm, 101.5 mm and 43 mm, which is a ball that rolls: of the limit of 150 mm.
  for (const double z : {0.12, 0.08, Story::radius}) {
    const double below = (0.15 - z - Story::radius) / 0.04;
    const auto goals = shot(0, z, Event::Goal);
    ASSERT_EQ(goals.size(), 1u) << z;
    EXPECT_EQ(goals[0].close(), below < 1) << z;
    const auto chips = shot(0, z, Event::ChippedGoal);
    ASSERT_EQ(chips.size(), below < 2 ? 1u : 0u) << z;
    if (!chips.empty()) {
      EXPECT_NEAR(chips[0].margin, -below, exact);
    }
  }
}

TEST(Goals, DoNotCountWhenTheBallWasTooHigh) {
  // Top at 141.5 mm and at 151.5 mm: the law says 150 mm; under the bar both.
  EXPECT_EQ(shot(0, 0.12, Event::Goal).size(), 1u);
  const auto chipped = shot(0, 0.13, Event::ChippedGoal);
  ASSERT_EQ(chipped.size(), 1u);
  EXPECT_EQ(chipped[0].by, yellow(3));
  EXPECT_NEAR(chipped[0].margin, 0.0015 / 0.04, exact);
}

TEST(Goals, CountAfterATeamMateTouchedTheBallLowOrItRolled) {
  for (const bool team_mate : {true, false}) {
    Story story;
    story.ball.position = {2, 0, 0.3};
    story.touch(yellow(3));
    story.tick(2);
    story.ball.position.z() = team_mate ? 0.05 : Story::radius;
    if (team_mate) story.touch(yellow(4));
    story.tick(team_mate ? 1 : 3);
    story.ball.velocity = {4, 0, 0};
    story.tick(39);
    story.ball.velocity.setZero();
    story.tick(40);
    EXPECT_EQ(story.told(Event::Goal).size(), 1u) << team_mate;
    for (const TrueEvent& chip : story.told(Event::ChippedGoal)) EXPECT_FALSE(chip.happened()) << team_mate;
  }
}

TEST(Icing, IsAKickFromTheOwnHalfOverTheOpponentsGoalLine) {
  // Yellow defends -x; the limit is 0.2 m behind the halfway line.
  for (const double x : {-0.3, -0.21, -0.19, 0.5}) {
    Story story;
    story.ball.position = {x, 1.5, Story::radius};
    story.touch(yellow(1));
    story.ball.velocity = {6, 0, 0};
    const int ticks = static_cast<int>((4.6 - x) / 0.1) + 1;
    story.tick(ticks + 30);
    const auto icing = story.told(Event::AimlessKick);
    if (x > 0) {
      EXPECT_TRUE(icing.empty());
      continue;
    }
    ASSERT_EQ(icing.size(), 1u) << x;
    EXPECT_NEAR(icing[0].value, -x - 0.2, exact);
    EXPECT_EQ(icing[0].happened(), x < -0.2);
  }
}

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

/// Yellow 2 pushes the ball in front of it at 1 m/s.
std::vector<TrueEvent> dribble(int ticks, int lets_go_at) {
  Story story;
  story.ball.position = {0, 0, Story::radius};
  story.robot(yellow(2), {-0.0945, 0});
  story.touch(yellow(2));
  story.tick();
  story.ball.velocity = {1, 0, 0};
  story.robot(yellow(2)).velocity = {1, 0};
  for (int n = 0; n < ticks; ++n) {
    if (n == lets_go_at) story.ball.position.x() += 0.03;
    if (n == lets_go_at + 1) story.ball.position.x() -= 0.03;
    story.touch(yellow(2));
    story.tick();
  }
  story.ball.position.x() += 0.04;
  story.tick(2);
  return story.told(Event::DribbledTooFar);
}

TEST(Dribbles, AreMeasuredFromTheFirstContactUntilTheBallIsLetGo) {
  const auto far = dribble(63, -5);  // 1.05 m
  ASSERT_EQ(far.size(), 1u);
  EXPECT_NEAR(far[0].margin, 0.05 / 0.04, exact);
  EXPECT_EQ(far[0].by, yellow(2));
  EXPECT_TRUE(dribble(63, 30).empty());
  const auto nearly = dribble(57, -5);  // 0.95 m
  ASSERT_EQ(nearly.size(), 1u);
  EXPECT_NEAR(nearly[0].margin, -0.05 / 0.04, exact);
}

TEST(Dribbles, AreCloseWhenOnlyTheSeparationIsInDoubt) {
  Story story;
  story.ball.position = {0, 0, Story::radius};
  story.robot(yellow(2), {-0.0945, 0});
  story.touch(yellow(2));
  story.tick();
  story.ball.velocity = {1, 0, 0};
  story.robot(yellow(2)).velocity = {1, 0};
  for (int n = 0; n < 66; ++n) {
    if (n == 30) story.ball.position.x() += 0.04;
    if (n == 32) story.ball.position.x() -= 0.04;
    story.touch(yellow(2));
    story.tick();
  }
  story.ball.position.x() += 0.1;
  story.tick(2);
  const auto told = story.told(Event::DribbledTooFar);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].margin, -0.5);
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

/// Yellow 1 kicks a free kick 0.3 m and touches it again, if nobody else does before.
Story second_touch(bool other_first) {
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

/// The same second touch, `ticks` after play was stopped.
std::vector<TrueEvent> touch_after_whistle(int ticks) {
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

TEST(Areas, BeginWhenTheHullIsInAndLastAsLongAsTheTouch) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(yellow(3), {3.0, 0}, {0.5, 0});  // its hull meets blue's area after 0.82 s, at x = 3.41
  story.ball.position = {3.0945, 0, Story::radius};
  story.ball.velocity = {0.5, 0, 0};
  for (int n = 0; n < 90; ++n) {
    story.touch(yellow(3));
    story.tick();
  }
  story.tick(20);
  const auto told = story.told(Event::AttackerInArea);
  ASSERT_EQ(told.size(), 1u);
  const double begins = 0.82 + world::tick_length;           // the story's first tick came before
  EXPECT_NEAR(world::seconds(told[0].time), begins, 0.018);  // a tick
  EXPECT_NEAR(world::seconds(*told[0].until), 1.5 + world::tick_length, 0.018);
  EXPECT_FALSE(told[0].ambiguous);
}

/// Blue 3 stands 0.49 m deep in its own area and touches the ball five times, `other` right before each time.
std::vector<TrueEvent> touches_with(std::optional<world::RobotId> other, Event event) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(3), {3.9, 0});
  story.ball.position = {4.0, 0, Story::radius};
  for (int n = 0; n < 5; ++n) {
    if (other) story.touch(*other, 0.01, 2);
    story.touch(blue(3), 0.01, 4);
    story.tick();
  }
  story.tick(20);
  return story.told(event);
}

TEST(Areas, AreAmbiguousAmongOpponentsOnly) {
  const auto among_opponents = touches_with(yellow(2), Event::DefenderInArea);
  ASSERT_EQ(among_opponents.size(), 1u);
  EXPECT_TRUE(among_opponents[0].ambiguous);
  const auto with_goalie = touches_with(blue(0), Event::DefenderInArea);
  ASSERT_EQ(with_goalie.size(), 1u);
  EXPECT_FALSE(with_goalie[0].ambiguous) << "it touched the ball, whoever else did";
  const auto alone = touches_with({}, Event::DefenderInArea);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_FALSE(alone[0].ambiguous);
  EXPECT_EQ(alone[0].clear, alone[0].time) << "a band deep from the first touch on";
}

TEST(Areas, AreClearOnceABandDeep) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(3), {3.0, 0}, {0.3, 0});  // the hull is in the area from x = 3.41 on, a band at 3.45
  story.ball.position = {3.0945, 0, Story::radius};
  story.ball.velocity = {0.3, 0, 0};
  for (int n = 0; n < 120; ++n) {
    story.touch(blue(3));
    story.tick();
  }
  story.tick(20);
  const auto told = story.told(Event::DefenderInArea);
  ASSERT_EQ(told.size(), 1u);
  ASSERT_TRUE(told[0].clear);
  EXPECT_NEAR(world::seconds(*told[0].clear - told[0].time), 0.04 / 0.3, 0.018);  // a tick
}

TEST(Areas, TellAClearOffenceBesideANearMissAndOneForAllAtOnce) {
  for (const double other : {3.36, 3.9}) {  // hull 50 mm outside the area, and deep inside
    Story story;
    story.state.keeper = {0, 0};
    story.robot(blue(2), {other, 0.2});
    story.robot(blue(3), {3.9, 0});
    story.ball.position = {3.8, 0, Story::radius};
    for (int n = 0; n < 5; ++n) {
      story.touch(blue(2), 0.01, 2);
      story.touch(blue(3), 0.01, 4);
      story.tick();
    }
    story.tick(60);
    const auto told = story.told(Event::DefenderInArea);
    EXPECT_EQ(std::ranges::count_if(told, [](const TrueEvent& one) { return one.margin >= 1; }), 1) << other;
  }
}

TEST(Areas, TellTouchesLessThanThreeTenthsOfASecondApartOnce) {
  for (const int pause : {12, 24}) {  // 0.2 s and 0.4 s
    Story story;
    story.state.keeper = {0, 0};
    story.robot(blue(3), {3.9, 0});
    story.ball.position = {4.0, 0, Story::radius};
    story.touch(blue(3));
    story.tick(pause);
    story.touch(blue(3));
    story.tick(30);
    EXPECT_EQ(story.told(Event::DefenderInArea).size(), pause == 12 ? 1u : 2u) << pause;
  }
}

TEST(Areas, AreForTheGoalieAlone) {
  // Blue's area is 1 m deep in the middle: from x = 3.5 on.
  for (const int number : {0, 3}) {
    Story story;
    story.state.keeper = {0, 0};
    story.robot(blue(number), {3.46, 0});  // the hull 50 mm inside
    story.ball.position = {3.35, 0, Story::radius};
    story.touch(blue(number));
    story.tick(20);
    const auto defenders = story.told(Event::DefenderInArea);
    ASSERT_EQ(defenders.size(), number == 0 ? 0u : 1u);
    if (number != 0) {
      EXPECT_NEAR(defenders[0].value, 0.05, exact);
    }
    EXPECT_TRUE(story.told(Event::AttackerInArea).empty());
  }
  Story story;
  story.robot(yellow(0), {3.46, 0});
  story.ball.position = {3.35, 0, Story::radius};
  story.touch(yellow(0));
  story.tick(20);
  EXPECT_EQ(story.told(Event::AttackerInArea).size(), 1u) << "there a goalie is a robot like any other";
}

TEST(Contacts, AreCollisionsWhenTheyCloseInTooFast) {
  for (const double speed : {2.0, 1.4, 0.5}) {
    Story story;
    story.robot(yellow(1), {-1, 0}, {speed, 0});
    story.robot(blue(1), {0, 0});
    const int ticks = static_cast<int>(0.82 / speed * 60) + 1;  // the hulls meet in the last
    story.tick(ticks);
    story.robot(yellow(1)).velocity.setZero();
    story.tick(5);
    story.robot(yellow(1)).velocity = {-1, 0};
    story.tick(20);
    const auto hits = story.told(Event::Collision);
    if (speed < 1.1) {
      EXPECT_TRUE(hits.empty());
      continue;
    }
    ASSERT_EQ(hits.size(), 1u) << speed;
    EXPECT_NEAR(hits[0].margin, (speed - 1.5) / 0.2, exact);
    EXPECT_EQ(hits[0].by, yellow(1));
  }
}

/// Yellow 1 drives at blue's goalie, who stands 0.5 m deep in its area, stops `gap` from its hull and stays
/// for so many ticks.
std::vector<TrueEvent> at_the_goalie(double gap, int ticks) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(0), {4, 0});
  story.robot(yellow(1), {3.5, 0}, {0.6, 0});
  story.tick(20);
  story.robot(yellow(1)).position.x() = 4 - 0.18 - gap;
  story.robot(yellow(1)).velocity.setZero();
  story.tick(ticks);
  story.robot(yellow(1)).position.x() = 3.5;
  story.tick(2);
  return story.told(Event::KeeperTouched);
}

TEST(Contacts, WithTheGoalieCountByHowLongTheyLastAndMissesByTheGap) {
  const auto pushed = at_the_goalie(0.0005, 30);
  ASSERT_EQ(pushed.size(), 1u);
  EXPECT_NEAR(pushed[0].margin, 0.5 / 0.2, exact);  // 30 ticks in bands of time
  EXPECT_EQ(pushed[0].by, yellow(1));
  const auto bumped = at_the_goalie(0.0005, 6);
  ASSERT_EQ(bumped.size(), 1u);
  EXPECT_TRUE(bumped[0].happened() && bumped[0].close());
  const auto near = at_the_goalie(0.03, 30);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_NEAR(near[0].margin, -0.03 / 0.04, exact);
  EXPECT_TRUE(at_the_goalie(0.09, 30).empty());
}

TEST(Contacts, EndTwentyMillimetresApart) {
  for (const double gap : {0.015, 0.05}) {
    Story story;
    story.robot(yellow(1), {-0.6, 0}, {2, 0});
    story.robot(blue(1), {0, 0});
    for (int meeting = 0; meeting < 2; ++meeting) {
      story.robot(yellow(1)).velocity = {2, 0};
      story.tick(meeting == 0 ? 13 : 2);  // the hulls meet
      story.robot(yellow(1)).velocity.setZero();
      story.robot(yellow(1)).position.x() = -0.18;
      story.tick(2);
      story.robot(yellow(1)).position.x() = -0.18 - gap;
      story.tick(2);
    }
    story.robot(yellow(1)).position.x() = -1;
    story.tick(2);
    const auto hits = story.told(Event::Collision);
    EXPECT_EQ(std::ranges::count_if(hits, &TrueEvent::happened), gap < 0.02 ? 1 : 2) << gap;
  }
}

TEST(Stops, KnowASpeedOnlyWhenItLasts) {
  for (const int ticks : {30, 12}) {  // half a second and a fifth; the limit is 0.3 s
    Story story;
    story.enter(Location::GameOff);
    story.state.command = {world::CommandKind::Stop, world::Team::Yellow};
    story.robot(blue(2), {-3, 2});
    story.tick(150);  // the grace of 2 s is over
    story.robot(blue(2)).velocity = {1.9, 0};
    story.tick(ticks);
    story.robot(blue(2)).velocity.setZero();
    story.tick(30);
    story.enter(Location::GameOn);
    story.tick(2);
    const auto fast = story.told(Event::TooFastInStop);
    ASSERT_EQ(fast.size(), ticks == 30 ? 1u : 0u);
    if (ticks == 30) {
      EXPECT_NEAR(fast[0].margin, 0.4 / 0.2, exact);
    }
  }
}

TEST(Stops, KnowWhoStaysNearAndInTheWay) {
  Story story;
  story.enter(Location::GameOff);
  story.state.command = {world::CommandKind::Stop, world::Team::Yellow};
  story.state.reset_position = world::Vector2d{2, 0};
  story.robot(blue(2), {0, 0.53});    // hull 0.44 m from the ball, on the way's beginning
  story.robot(yellow(1), {1, 0.57});  // hull 0.48 m from the way, 0.97 m from the ball
  story.robot(yellow(2), {1, -0.8});
  story.tick(200);
  story.enter(Location::GameOn);
  story.tick(2);
  const auto near = story.told(Event::TooNearInStop);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].by, blue(2));
  EXPECT_NEAR(near[0].margin, 0.06 / 0.04, exact);
  const auto way = story.told(Event::InterferedPlacement);
  ASSERT_EQ(way.size(), 2u);
  EXPECT_EQ(way[0].by, yellow(1));
  EXPECT_NEAR(way[0].margin, 0.02 / 0.04, exact);
  EXPECT_EQ(way[1].by, blue(2));
}

TEST(RobotsOff, StayedOutsideForAllOfTheTime) {
  for (const int ticks : {130, 110}) {  // the limit is 2 s
    Story story;
    story.robot(blue(2), {0, 3.35});
    story.tick(ticks);
    story.robot(blue(2)).position.y() = 3.0;
    story.tick(2);
    EXPECT_EQ(story.told(Event::RobotLeftField).size(), ticks == 130 ? 1u : 0u);
  }
}

TEST(RobotsOff, AreToldOnceUntilTheyAreBack) {
  Story story;
  story.robot(blue(2), {0, 3.35});
  for (int passage = 0; passage < 3; ++passage) {
    story.tick(130);
    story.enter(Location::GameOff);
    story.tick(5);
    story.enter(Location::GameOn);
    if (passage == 1) {
      story.robot(blue(2)).position.y() = 3.0;
      story.tick();
      story.robot(blue(2)).position.y() = 3.35;
    }
  }
  story.tick();
  EXPECT_EQ(story.told(Event::RobotLeftField).size(), 2u);
}

TEST(RobotsOff, CountsThoseThatMayPlay) {
  Story story;
  story.state.red_cards.blue = 1;
  story.enter(Location::GameOn);
  for (int n = 0; n < 6; ++n) story.robot(blue(n), {0.3 * n, 1});
  story.tick(200);
  const auto many = story.told(Event::TooManyRobots);
  ASSERT_EQ(many.size(), 1u);
  EXPECT_EQ(many[0].by->team, world::Team::Blue);
}

TEST(Progress, IsAQuarterOfAMetreInAnySecond) {
  Story stuck;
  stuck.tick(12 * 60 + 5);
  ASSERT_EQ(stuck.told(Event::NoProgress).size(), 1u);
  EXPECT_NEAR(stuck.told(Event::NoProgress)[0].margin, 0.25 / 0.04, exact);
  Story rolls;
  rolls.ball.velocity = {0.26, 0, 0};
  rolls.tick(12 * 60 + 5);
  for (const TrueEvent& event : rolls.told(Event::NoProgress)) EXPECT_FALSE(event.happened());
}

TEST(Progress, IsNoMatterWhileTheGoalieHoldsTheBall) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(0), {4.2, 0}).orientation = 3.14159265358979323846;
  story.ball.position = {4.2 - 0.0945, 0, Story::radius};
  story.tick(16 * 60);
  EXPECT_TRUE(story.told(Event::NoProgress).empty());
  const auto held = story.told(Event::KeeperHeldBall);
  ASSERT_EQ(held.size(), 1u);
  EXPECT_EQ(held[0].by, blue(0));
}

TEST(Settling, NeedsASecondOfSlowRobots) {
  Story story;
  story.enter(Location::GameOff);
  story.state.reset_position = world::Vector2d{0, 0};
  story.robot(blue(2), {-1, 2}, {0.7, 0});
  story.tick(60);
  const double slow = story.now();
  story.robot(blue(2)).velocity.setZero();
  story.tick(70);
  story.enter(Location::Setup);
  story.tick(30);
  const auto settled = story.told(Event::RobotsSettled);
  ASSERT_EQ(settled.size(), 1u);
  EXPECT_NEAR(world::seconds(settled[0].time), slow + 1, 1.0 / 60 + exact);  // counted in ticks
  EXPECT_GE(settled[0].margin, 1);
}

/// Waits with a robot that drives in a circle at that speed, and a ball that lies that far from its place.
/// @return when the robots had settled [s] after the wait began; nothing: it was not told
std::optional<TrueEvent> wait(double speed, double off, bool kickoff = false, double x = -1,
                              int ticks = 2000) {
  Story story;
  story.enter(Location::GameOff);
  story.state.reset_position = world::Vector2d{off, 0};
  story.state.is_kickoff = kickoff;
  truth::Robot& robot = story.robot(yellow(2), {x, 2});
  for (int n = 0; n < ticks; ++n) {
    robot.velocity = speed * world::direction(0.05 * n);
    story.tick();
  }
  story.enter(Location::Setup);
  story.tick(30);
  const auto told = story.told(Event::RobotsSettled);
  if (told.empty()) return std::nullopt;
  return told[0];
}

double after_wait(const TrueEvent& event) { return world::seconds(event.time) - world::tick_length; }

TEST(Settling, KnowsTheLimitOfSpeedWithItsBand) {
  // Slower than 0.3 m/s, by a band below 0.4, and faster than 0.5.
  const auto slow = wait(0.29, 0);
  ASSERT_TRUE(slow);
  EXPECT_GE(slow->margin, 1);
  EXPECT_NEAR(after_wait(*slow), 1, 2 * world::tick_length);
  const auto fast = wait(0.52, 0);
  ASSERT_TRUE(fast);
  EXPECT_GE(fast->margin, 1);
  EXPECT_NEAR(after_wait(*fast), 15, 2 * world::tick_length) << "the wait is over";
  for (const double about : {0.36, 0.44}) {
    const auto close = wait(about, 0);
    ASSERT_TRUE(close);
    EXPECT_TRUE(close->close()) << about;
    EXPECT_NEAR(after_wait(*close), 1, 2 * world::tick_length) << "the first that is right";
    ASSERT_TRUE(close->until);
    EXPECT_NEAR(world::seconds(*close->until) - world::tick_length, 15, 2 * world::tick_length);
  }
}

TEST(Settling, NeedsTheBallInItsPlace) {
  EXPECT_NEAR(after_wait(*wait(0, 0.025)), 1, 2 * world::tick_length);  // 50 mm less a band of 20 mm
  EXPECT_NEAR(after_wait(*wait(0, 0.075)), 15, 2 * world::tick_length);
  EXPECT_TRUE(wait(0, 0.055)->close());
}

TEST(Settling, WaitsTwiceAsLongForRobotsInTheWrongHalf) {
  // Yellow defends -x.
  EXPECT_NEAR(after_wait(*wait(0, 0, true, -0.05)), 1, 2 * world::tick_length);
  EXPECT_NEAR(after_wait(*wait(0, 0, true, 0.05)), 30, 2 * world::tick_length);
  EXPECT_NEAR(after_wait(*wait(0, 0, false, 0.05)), 1, 2 * world::tick_length) << "only at a kickoff";
  EXPECT_TRUE(wait(0, 0, true, 0.02)->close());
}

TEST(Settling, IsNotToldWhenPlayGoesOnBefore) { EXPECT_FALSE(wait(0.2, 0, false, -1, 30)); }

// The numbers of the laws, each with a scene a little on either side of it: moved, one of them fails.
TEST(Limits, OfTimeAreThoseOfTheLaws) {
  const auto held = [](double seconds) {
    Story story;
    story.state.keeper = {0, 0};
    story.robot(blue(0), {4.2, 0}).orientation = 3.14159265358979323846;
    story.ball.position = {4.2 - 0.0945, 0, Story::radius};
    story.tick(static_cast<int>(seconds * 60));
    story.ball.position.x() = 4.2 - 0.14;  // lets go: 45 mm in front of it
    story.tick(40);
    const auto told = story.told(Event::KeeperHeldBall);
    return !told.empty() && told[0].happened();
  };
  EXPECT_FALSE(held(14.9));
  EXPECT_TRUE(held(15.1));

  const auto stuck = [](double seconds, double speed) {
    Story story;
    story.enter(Location::GameOn);
    story.ball.velocity = {speed, 0, 0};
    story.tick(static_cast<int>(seconds * 60));
    const auto told = story.told(Event::NoProgress);
    return std::ranges::any_of(told, [](const TrueEvent& one) { return one.happened(); });
  };
  EXPECT_FALSE(stuck(11.9, 0));
  EXPECT_TRUE(stuck(12.1, 0));
  EXPECT_TRUE(stuck(13.5, 0.24));
  EXPECT_FALSE(stuck(13.5, 0.26));

  const auto seven = [](double seconds) {
    Story story;
    story.enter(Location::GameOn);
    for (int n = 0; n < 7; ++n) story.robot(blue(n), {0.3 * n, 1});
    story.tick(static_cast<int>(seconds * 60));
    return !story.told(Event::TooManyRobots).empty();
  };
  EXPECT_FALSE(seven(1.9));
  EXPECT_TRUE(seven(2.1));
}

TEST(Limits, OfPlacesAndSpeedsAreThoseOfTheLaws) {
  const auto out = [](double y) {
    Story story;
    story.robot(blue(2), {0, y});
    story.tick(130);
    story.robot(blue(2)).position.y() = 2;
    story.tick(2);
    const auto told = story.told(Event::RobotLeftField);
    return !told.empty() && told[0].happened();
  };
  EXPECT_FALSE(out(3.24));  // of the centre: 0.25 m beyond the touch line
  EXPECT_TRUE(out(3.26));

  // Margins say which limit they are measured from.
  Story story;
  story.enter(Location::Setup);
  story.state.kick_team = world::Team::Yellow;
  story.state.is_kickoff = true;
  story.robot(yellow(1), {-0.0945, 0});
  story.robot(yellow(2), {0.03, 2});
  story.tick(3);
  story.touch(yellow(1));
  story.ball.velocity = {3, 0, 0};
  story.tick(3);
  story.enter(Location::GameOn);
  story.tick(25);
  const auto half = story.told(Event::WrongHalf);
  ASSERT_EQ(half.size(), 1u);
  EXPECT_EQ(half[0].by, yellow(2));
  EXPECT_NEAR(half[0].margin, 0.03 / 0.04, exact);
}

TEST(HullDistance, IsADiscWithAFlatFront) {
  const world::Field field;
  truth::Robot robot;
  EXPECT_NEAR(hull_distance(field, robot, {0.2, 0}), 0.2 - 0.073, exact);
  EXPECT_NEAR(hull_distance(field, robot, {-0.2, 0}), 0.2 - 0.09, exact);
  EXPECT_NEAR(hull_distance(field, robot, {0, 0.2}), 0.2 - 0.09, exact);
  // Continuous where plate, corner and arc meet: around the robot no jump above the step's own length.
  double before = hull_distance(field, robot, {0.12, 0});
  for (int n = 1; n <= 3600; ++n) {
    const double now = hull_distance(field, robot, 0.12 * world::direction(n * 0.001745329));
    EXPECT_LT(std::abs(now - before), 0.12 * 0.0018) << n;
    before = now;
  }
}

}  // namespace
}  // namespace judge
