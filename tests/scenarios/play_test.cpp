// What happens in play, foul and almost-foul alike.
#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using world::CommandKind;
using world::Location;
using world::Team;
using world::Vector2d;

void expect_near(const Vector2d& actual, const Vector2d& expected, double tolerance = 1e-6) {
  EXPECT_LT((actual - expected).norm(), tolerance)
      << actual.transpose() << " instead of " << expected.transpose();
}

class PlayScenario : public Scenario {};

// A story in play, with what led there forgotten.
Story in_play(const View& view, const std::string& rules = "ssl-2015") {
  Story story(view, rules);
  story.begin();
  EXPECT_EQ(story.state().location, Location::GameOn);
  story.commands();
  story.rows();
  return story;
}

TEST_P(PlayScenario, ABallThatOnlyJustTouchesTheLineIsInPlay) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.02});  // the whole ball is out at 3.0215
  story.wait(1);
  EXPECT_EQ(story.commands(), "");
}

TEST_P(PlayScenario, ABallOutsideForTwoFramesOnlyIsInPlay) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 2.95});
  for (const double y : {3.03, 3.03, 2.99}) {
    story.put_ball({0.5, y});
    story.tick();
  }
  story.wait(0.5);
  EXPECT_EQ(story.commands(), "");
}

TEST_P(PlayScenario, AnExitIsMeasuredWhereTheBallCrossedTheLine) {
  Story story = in_play(GetParam());
  story.put_ball({0, 2});
  story.kick(yellow(3), {1.0, 3.5});
  EXPECT_EQ(story.kick_team(), Team::Blue);
  expect_near(story.reset_position(), {(3.0215 - 2) * 1.0 / 1.5, 2.9});
  EXPECT_EQ(story.commands(), "STOP");
}

TEST_P(PlayScenario, ACornerKickWhenTheDefenderTouchedLast) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {4.8, 1.5});
  EXPECT_EQ(story.kick_team(), Team::Yellow);
  expect_near(story.reset_position(), {4.4, 2.9});
  EXPECT_NE(story.last_call().restart.find("corner kick"), std::string::npos);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP DIRECT(yellow)");
}

TEST_P(PlayScenario, AGoalKickWhenTheAttackerTouchedLast) {
  Story story = in_play(GetParam());
  story.kick(yellow(3), {4.8, 1.5});
  EXPECT_EQ(story.kick_team(), Team::Blue);
  expect_near(story.reset_position(), {4.0, 2.9});
  EXPECT_NE(story.last_call().restart.find("goal kick"), std::string::npos);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP DIRECT(blue)");
}

TEST_P(PlayScenario, APaperGoalLineExitIsIndirect) {
  Story story = in_play(GetParam(), "paper");
  story.kick(yellow(3), {4.8, 1.5});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP INDIRECT(blue)");
}

TEST_P(PlayScenario, AShotAtThePostThatComesBackIsNoGoal) {
  Story story = in_play(GetParam());
  story.kick(yellow(3), {4.51, 0.49});
  story.roll({3.0, 1.0});
  EXPECT_EQ(story.commands(), "");
}

TEST_P(PlayScenario, AGoalCountsWhenTheBallBouncesOutAgain) {
  Story story = in_play(GetParam());
  story.kick(yellow(3), {4.64, 0.2}, 6);
  story.roll({3.5, 0.2}, 3);
  EXPECT_EQ(story.commands(), "GOAL(yellow)");
}

TEST_P(PlayScenario, AnOwnGoalCountsForTheOthers) {
  Story story = in_play(GetParam());
  story.kick(yellow(3), {-4.65, 0});
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "GOAL(blue)");
  EXPECT_EQ(story.kick_team(), Team::Yellow);
  EXPECT_EQ(story.score(Team::Blue), 1);
}

TEST_P(PlayScenario, ABallOverTheGoalIsAnExit) {
  Story story = in_play(GetParam());
  story.kick(yellow(3), {5.1, 0.1}, 4);
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.score(Team::Yellow), 0);
  EXPECT_EQ(story.kick_team(), Team::Blue);
}

TEST_P(PlayScenario, NoGoalStraightFromAnIndirectKick) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {4.65, 0}, 6);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) STOP");
  EXPECT_EQ(story.score(Team::Yellow), 0);
  EXPECT_EQ(story.state().restart, CommandKind::Direct);  // a goal kick
  EXPECT_EQ(story.kick_team(), Team::Blue);
}

TEST_P(PlayScenario, AGoalFromAnIndirectKickThatATeamMateTouched) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {2, 0}, 3);
  story.kick(yellow(5), {4.65, 0}, 6);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) GOAL(yellow)");
  EXPECT_EQ(story.score(Team::Yellow), 1);
}

TEST_P(PlayScenario, AGoalStraightFromADirectKickCounts) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {4.8, 1.5});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {4.4, 0.4}, 6);
  story.roll({4.65, 0.1}, 6);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "STOP DIRECT(yellow) GOAL(yellow)");
}

TEST_P(PlayScenario, TheKickerMayNotTouchTheBallTwice) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {0.5, 1.0}, 2);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow)");
  story.kick(yellow(3), {0.5, 0.0}, 2);
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.last_call().row, "T11.6");
  EXPECT_EQ(story.kick_team(), Team::Blue);
  EXPECT_TRUE(story.last_call().offender == story.seen(yellow(3)));
}

TEST_P(PlayScenario, TheKickerMayTouchTheBallAfterSomeoneElseDid) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {0.5, 1.0}, 2);
  story.kick(yellow(4), {1.0, 1.0}, 2);
  story.kick(yellow(3), {0.5, 0.0}, 2);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow)");
}

TEST_P(PlayScenario, TheKickersOwnKickReportedLateIsNoDoubleTouch) {  // I-33
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  for (const double y : {2.85, 2.75, 2.65}) {  // reported as touching for three more frames
    story.touch(yellow(3));
    story.put(yellow(3), {0.5, 2.99});
    story.roll({0.5, y}, 6);
  }
  story.wait(0.5);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow)");
}

TEST_P(PlayScenario, TheKickerMayNotCarryTheBallAway) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.dribble(yellow(3), {0.5, 2.0});
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) STOP");
  EXPECT_EQ(story.last_call().row, "T11.6");
}

TEST_P(PlayScenario, AStuckBallIsANeutralStart) {
  Story story = in_play(GetParam());
  story.put_ball({3.0, 0.5});
  story.wait(11);
  EXPECT_EQ(story.commands(), "");
  story.wait(2);
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.last_call().row, "T11.2");
  EXPECT_GE(world::distance_to_defense_area({}, world::Side::Positive, story.reset_position()), 0.7 - 1e-9);
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "START");
}

TEST_P(PlayScenario, ALostBallIsStuckToo) {
  Story story = in_play(GetParam());
  story.hide_ball();
  story.wait(13);
  EXPECT_EQ(story.commands(), "STOP");
  story.hide_ball(false);
  EXPECT_TRUE(story.wait_for(Location::GameOn));
}

TEST_P(PlayScenario, DribblingAMetreIsAFoul) {
  Story story = in_play(GetParam());
  story.dribble(yellow(4), {0.5, 1.2});
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.last_call().row, "T11.3");
  EXPECT_EQ(story.kick_team(), Team::Blue);
  expect_near(story.reset_position(), {0.5, 1.017},
              0.02);  // the frame after 1 m from the dribble's first frame
}

TEST_P(PlayScenario, DribblingLessThanAMetreIsNone) {
  Story story = in_play(GetParam());
  story.dribble(yellow(4), {0.5, 0.95});
  story.kick(yellow(4), {0.5, 1.5});
  EXPECT_EQ(story.commands(), "");
}

TEST_P(PlayScenario, ABallKickedTooFastIsAFoul) {
  Story story = in_play(GetParam());
  const Vector2d from = story.ball();
  story.kick(yellow(4), {4.0, 2.0}, 9.0);
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.last_call().row, "T11.3");
  EXPECT_TRUE(story.last_call().offender == story.seen(yellow(4)));
  expect_near(story.reset_position(), from, 0.2);  // touch places are known to a frame of a 9 m/s ball
}

TEST_P(PlayScenario, EightMetresPerSecondAreAllowed) {
  Story story = in_play(GetParam());
  story.kick(yellow(4), {4.0, 2.0}, 8.0);
  EXPECT_EQ(story.commands(), "");
}

TEST_P(PlayScenario, ABallThatJumpsIsNeitherTooFastNorOut) {
  Story story = in_play(GetParam());
  for (int i = 0; i < 5; ++i) {  // a false ball far outside, for up to ten frames
    const Vector2d place = story.ball();
    story.put_ball({0, 3.6});
    for (int frame = 0; frame < 2 * i; ++frame) story.tick();
    story.put_ball(place);
    story.wait(0.2);
  }
  EXPECT_EQ(story.commands(), "");
}

TEST_P(PlayScenario, ATouchByTheDefenderInTheSameTickAsTheExitCounts) {
  Story story = in_play(GetParam());
  story.kick(yellow(4), {0.5, 2.99}, 3);
  story.touch(blue(2));
  story.roll({0.5, 3.4}, 3);
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.kick_team(), Team::Yellow);
}

TEST_P(PlayScenario, ATouchOutsideTheFieldDoesNotCount) {
  Story story = in_play(GetParam());
  story.kick(yellow(4), {0.5, 3.03}, 3);
  story.touch(blue(2));
  story.roll({0.5, 3.4}, 3);
  EXPECT_EQ(story.kick_team(), Team::Blue);
}

INSTANTIATE_TEST_SUITE_P(Views, PlayScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
