// The truth's own laws on truth written by hand, of the ball leaving the field.
#include <gtest/gtest.h>

#include "experiments/judge/laws/laws.h"
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

// A kick from beside the line, and the referee notices it some ticks later:
// the ball left the field all the same.
TEST(Exits, CountFromTheKickThoughTheRefereeNoticesItLater) {
  for (const int noticed : {2, 3, 6}) {  // it is out in the second tick
    Story story;
    story.enter(Location::Setup);
    story.ball.position = {1, 2.97, Story::radius};
    story.tick(3);
    const double begin = story.now();
    story.touch(yellow(1), 0.2);
    story.ball.velocity = {0, 2, 0};
    story.tick(noticed - 1);
    story.enter(Location::GameOn);
    story.tick(60);
    const auto exits = story.told(Event::Exit);
    ASSERT_EQ(exits.size(), 1u) << noticed;
    EXPECT_NEAR(world::seconds(exits[0].time), begin + (0.03 + Story::radius) / 2, exact);
    EXPECT_EQ(exits[0].by, yellow(1));
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

}  // namespace
}  // namespace judge
