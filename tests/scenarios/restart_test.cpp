// How play is restarted: retakes, waits, halves and time-outs.
#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using world::CommandKind;
using world::Location;
using world::Stage;
using world::Team;
using world::Vector2d;

class RestartScenario : public Scenario {};

// Yellow is about to take an indirect kick from (0.5, 2.9).
Story at_free_kick(const View& view, const std::string& rules = "ssl-2015") {
  Story story(view, rules);
  story.begin();
  story.kick(blue(3), {0.5, 3.3});
  EXPECT_TRUE(story.wait_for(Location::Setup));
  story.commands();
  story.rows();
  return story;
}

TEST_P(RestartScenario, AnOpponentNearTheBallMeansTheSameKickAgain) {
  Story story = at_free_kick(GetParam());
  story.put(blue(2), {0.5, 2.9 - 0.55});  // its hull is 0.46 m away
  story.kick(yellow(3), {-0.5, 2.0});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.rows(), "T18.c T12.4");
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow)");
  EXPECT_LT((story.reset_position() - Vector2d(0.5, 2.9)).norm(), 1e-6);
}

TEST_P(RestartScenario, AnOpponentAtTheLegalDistanceIsFine) {
  Story story = at_free_kick(GetParam());
  story.put(blue(2), {0.5, 2.9 - 0.60});
  story.kick(yellow(3), {-0.5, 2.0});
  EXPECT_EQ(story.rows(), "T13");
}

TEST_P(RestartScenario, AnOpponentWhoTakesTheKickDoesNotGetAwayWithIt) {  // I-34
  Story story = at_free_kick(GetParam());
  story.kick(blue(2), {-0.5, 2.0});
  EXPECT_EQ(story.rows(), "T18.c");
  EXPECT_EQ(story.kick_team(), Team::Yellow);
}

TEST_P(RestartScenario, ATeamMateAtTheOpponentsAreaGivesTheKickAway) {
  Story story = at_free_kick(GetParam());
  story.put(yellow(4), {4.5 - 1.0 - 0.09 - 0.15, 0});  // its hull is 0.15 m from the area
  story.kick(yellow(3), {-0.5, 2.0});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.rows(), "T18.b T12.4");
  EXPECT_EQ(story.commands(), "STOP INDIRECT(blue)");
}

TEST_P(RestartScenario, ATeamMateTwentyFiveCentimetresFromTheAreaIsFine) {
  Story story = at_free_kick(GetParam());
  story.put(yellow(4), {4.5 - 1.0 - 0.09 - 0.25, 0});
  story.kick(yellow(3), {-0.5, 2.0});
  EXPECT_EQ(story.rows(), "T13");
}

TEST_P(RestartScenario, AKickoffWithARobotInTheWrongHalfIsTakenAgain) {
  Story story(GetParam());
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.put(yellow(5), {0.5, 2.0});
  story.kick(yellow(1), {1.0, 0});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(1), {1.0, 0});
  EXPECT_EQ(story.rows(), "T10 T15.a T12.1 T18.d T15.a T12.2 T13");
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY STOP KICKOFF(yellow) READY");
}

TEST_P(RestartScenario, AKickoffGoalCounts) {
  Story story(GetParam());
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(1), {4.65, 0}, 6);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY GOAL(yellow)");
}

TEST_P(RestartScenario, ABumpOfLessThanFiveCentimetresIsNoKick) {
  Story story = at_free_kick(GetParam());
  story.roll(story.ball() + Vector2d(0, -0.04), 0.3);
  EXPECT_EQ(story.state().location, Location::Setup);
  story.roll(story.ball() + Vector2d(0, -0.04), 0.3);
  EXPECT_EQ(story.state().location, Location::GameOn);
}

TEST_P(RestartScenario, TheRefereeWaitsForTheBallAndAsksAgain) {
  Story story = at_free_kick(GetParam());
  story.kick(yellow(3), {0.5, -3.3});
  ASSERT_EQ(story.state().location, Location::GameOff);
  story.wait(0.7);  // the ball is in place
  story.put_ball({0, 0});
  story.wait(1.3);  // it was moved away; the referee asks again and the host obeys
  EXPECT_LT((story.ball() - story.reset_position()).norm(), 1e-6);
  ASSERT_TRUE(story.wait_for(Location::Setup));
}

TEST_P(RestartScenario, AHalfEndsAtTheFirstStoppageAfterItsTime) {
  Story story(GetParam(), "ssl-2015", 20);
  story.begin();
  for (int i = 0; i < 6; ++i) {  // 25 s of passing
    story.kick(yellow(3), {0.5, i % 2 ? 1.0 : -1.0}, 1.0);
    story.wait(3);
  }
  EXPECT_EQ(story.state().stage, Stage::First);
  EXPECT_LT(*story.referee().message().stage_time_left, world::Duration::zero());
  story.commands();
  const bool blue_on_positive_half = story.state().blue_on_positive_half;
  story.kick(yellow(3), {0.5, 3.3});
  EXPECT_EQ(story.commands(), "STOP HALT KICKOFF(blue)");
  EXPECT_EQ(story.state().stage, Stage::PreSecond);
  EXPECT_NE(story.state().blue_on_positive_half, blue_on_positive_half);
}

TEST_P(RestartScenario, AHalfWithoutStoppageIsEndedAfterAMinute) {
  Story story(GetParam(), "ssl-2015", 10);
  story.begin();
  for (int i = 0; story.state().stage == Stage::First && i < 100; ++i) {
    story.kick(yellow(3), {0.5, i % 2 ? 1.0 : -1.0}, 1.0);
  }
  EXPECT_NE(story.rows().find("I-18.on T16.a"), std::string::npos);
}

// R-6.2-3: every stage, and the end.
TEST_P(RestartScenario, AWholeGameGoesThroughEveryStage) {
  Story story(GetParam(), "ssl-2015", 5);
  story.keep_robots();
  for (int half = 0; half < 2; ++half) {
    const double sign = half == 0 ? 1 : -1;
    for (int i = 0; i < 6; ++i) {
      story.put({Team::Yellow, static_cast<std::uint8_t>(i)}, {-1.5 * sign, i * 0.8 - 2});
      story.put({Team::Blue, static_cast<std::uint8_t>(i)}, {1.5 * sign, i * 0.8 - 2});
    }
    ASSERT_TRUE(story.wait_for(Location::Setup));
    EXPECT_EQ(story.state().stage, half == 0 ? Stage::First : Stage::Second);
    story.kick(half == 0 ? yellow(1) : blue(1), {sign * (half == 0 ? 1.0 : -1.0), 0});
    story.wait(5);
    story.roll({0, 3.4});
  }
  EXPECT_EQ(story.state().stage, Stage::Post);
  EXPECT_EQ(story.state().location, Location::Break);
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY STOP HALT KICKOFF(blue) READY STOP HALT");
  EXPECT_EQ(story.referee().loop_defects(), 0);
  story.wait(60);
  EXPECT_EQ(story.commands(), "");
}

TEST_P(RestartScenario, ATeamCallsATimeoutAndEndsIt) {
  Story story(GetParam());
  story.begin();
  const Team team = story.seen(Team::Blue);
  story.referee().request_timeout(team);
  story.wait(1);
  EXPECT_EQ(story.state().location, Location::GameOn);  // only while stopped
  story.kick(blue(3), {0.5, 3.3});
  EXPECT_EQ(story.state().location, Location::Break);
  story.wait(30);
  story.referee().end_timeout(team);
  story.tick();
  EXPECT_EQ(story.state().location, Location::GameOff);
  EXPECT_EQ(story.state().timeout_num[team], 3);
  EXPECT_NEAR(world::seconds(story.state().timeout_time[team]), 270, 0.1);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY STOP TIMEOUT(blue) STOP INDIRECT(yellow)");
}

TEST_P(RestartScenario, ATimeoutEndsWhenItIsUsedUp) {
  Story story(GetParam());
  story.wait(0.1);
  story.referee().request_timeout(story.seen(Team::Yellow));
  story.wait(299);
  EXPECT_EQ(story.state().location, Location::Break);
  story.wait(2);
  EXPECT_EQ(story.state().location, Location::GameOff);
  story.referee().request_timeout(story.seen(Team::Yellow));  // none of its time is left
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP TIMEOUT(yellow) STOP KICKOFF(yellow) READY");
}

// R-4.1-2: four, five minutes in all, only while play is stopped, and the half's clock stands.
TEST_P(RestartScenario, AFifthTimeoutIsRefusedAndTheClockStandsInAll) {
  Story story(GetParam());
  story.begin();
  const Team team = story.seen(Team::Blue);
  const world::Duration left = *story.referee().message().stage_time_left;
  story.commands();
  story.kick(blue(3), {0.5, 3.3});
  const double stopped = story.now();
  for (int i = 0; i < 5; ++i) {
    story.referee().request_timeout(team);
    story.tick();
    EXPECT_EQ(story.state().location, i < 4 ? Location::Break : Location::GameOff) << i;
    story.wait(i < 4 ? 30 : 0);
    story.referee().end_timeout(team);
    story.tick();
  }
  EXPECT_EQ(story.commands(),
            "STOP TIMEOUT(blue) STOP TIMEOUT(blue) STOP TIMEOUT(blue) STOP TIMEOUT(blue) STOP");
  EXPECT_EQ(story.state().timeout_num[team], 0);
  EXPECT_NEAR(world::seconds(story.state().timeout_time[team]), 300 - 4 * 30, 0.2);
  // The half lost only what was played: all but two minutes since it was stopped, and the play before.
  const double lost = world::seconds(left - *story.referee().message().stage_time_left);
  EXPECT_LT(lost, story.now() - stopped - 4 * 30 + 2);
}

TEST_P(RestartScenario, ATimeoutIsTheOtherTeamsToo) {
  Story story(GetParam());
  story.begin();
  story.kick(blue(3), {0.5, 3.3});
  const Team team = story.seen(Team::Yellow);
  story.referee().request_timeout(team);
  story.wait(10);
  story.referee().end_timeout(world::opponent(team));  // not its own
  story.tick();
  EXPECT_EQ(story.state().location, Location::Break);
  story.referee().request_timeout(world::opponent(team));  // waits until the first is over
  story.wait(10);
  story.referee().end_timeout(team);
  story.wait(0.1);
  EXPECT_EQ(story.state().timeout_team, world::opponent(team));
  EXPECT_NEAR(world::seconds(story.state().timeout_time[team]), 280, 0.1);
}

INSTANTIATE_TEST_SUITE_P(Views, RestartScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
