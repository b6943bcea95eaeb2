// The truth's own laws on truth written by hand, of robots in the areas and against each other.
#include <gtest/gtest.h>

#include "experiments/judge/laws/laws.h"
#include "tests/experiments/judge/story.h"

namespace judge {
namespace {

// Positions are sums of 1/60 s steps: far below this [m, s, bands].
constexpr double exact = 1e-6;

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

TEST(Areas, KnowATouchWithWhichTheGameEnds) {
  Story story;
  story.state.keeper = {0, 0};
  story.robot(blue(3), {3.9, 0});
  story.ball.position = {4.0, 0, Story::radius};
  story.touch(blue(3));
  story.tick();
  EXPECT_TRUE(story.told(Event::DefenderInArea).empty()) << "it may last";
  story.end();
  EXPECT_EQ(story.told(Event::DefenderInArea).size(), 1u);
}

TEST(Contacts, KnowAMeetingWithWhichTheGameEnds) {
  Story story;
  story.robot(blue(3), {0, 0.5});
  story.robot(yellow(2), {-0.2, 0.5}, {2, 0});  // hulls meet after 10 ms
  story.tick(2);
  EXPECT_TRUE(story.told(Event::Collision).empty()) << "they may part or push";
  story.end();
  EXPECT_EQ(story.told(Event::Collision).size(), 1u);
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

}  // namespace
}  // namespace judge
