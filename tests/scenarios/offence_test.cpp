// Offences of Law 12 beside those of play_test.cpp, foul and almost-foul: exactly, and through harsh cameras.
#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using world::CommandKind;
using world::Location;
using world::Team;
using world::Vector2d;

// Seen exactly, places are known to a frame of a fast robot. Through harsh cameras a touch is known to four
// frames of a ball of 5 m/s (0.33 m), and cameras are some 20 mm off.
double place_tolerance(const Story& story) { return story.harsh() ? 0.35 : 0.05; }

class OffenceScenario : public Scenario {};

// In play, the ball at rest at (0.5, 0), with what led there forgotten.
Story in_play(const View& view, const std::string& rules = "ssl-2015") {
  Story story(view, rules);
  story.begin();
  story.wait(0.5);
  EXPECT_EQ(story.state().location, Location::GameOn);
  story.commands();
  story.rows();
  return story;
}

void expect_stopped_by(Story& story, const std::string& row, CommandKind restart, Team kick_team,
                       world::RobotId offender) {
  EXPECT_EQ(story.commands(), "STOP");
  EXPECT_EQ(story.rows(), row);
  EXPECT_EQ(story.state().restart, restart);
  EXPECT_EQ(story.kick_team(), kick_team);
  ASSERT_FALSE(story.calls().empty());
  EXPECT_TRUE(story.last_call().offender == story.seen(offender)) << story.last_call().sentence;
}

void expect_place(Story& story, const Vector2d& place) {
  EXPECT_LT((story.reset_position() - place).norm(), place_tolerance(story))
      << story.reset_position().transpose() << " instead of " << place.transpose();
}

// --- Icing ---

TEST_P(OffenceScenario, AKickFromTheOwnHalfOverTheGoalLineIsIcing) {
  Story story = in_play(GetParam());
  story.roll({-1.0, 0.5}, 2.0);
  story.kick(yellow(4), {4.85, 1.5}, 5.0);
  story.wait(0.2);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(4));
  expect_place(story, {-1.0, 0.5});
}

TEST_P(OffenceScenario, AKickFromTheOtherHalfIsNoIcing) {
  Story story = in_play(GetParam());
  story.kick(yellow(4), {4.85, 1.5}, 5.0);
  story.wait(0.2);
  EXPECT_FALSE(story.saw("icing"));
  EXPECT_EQ(story.rows(), "T11.7");
}

TEST_P(OffenceScenario, AKickThatAnOpponentTouchedIsNoIcing) {
  Story story = in_play(GetParam());
  story.roll({-1.0, 0.5}, 2.0);
  story.kick(yellow(4), {2.5, 1.0}, 5.0);
  story.kick(blue(4), {4.85, 1.5}, 5.0);
  story.wait(0.2);
  EXPECT_FALSE(story.saw("icing"));
  EXPECT_EQ(story.rows(), "T11.7");
  EXPECT_EQ(story.kick_team(), Team::Yellow);  // a corner
}

TEST_P(OffenceScenario, ABallKickedBackOverTheOwnGoalLineIsNoIcing) {
  Story story = in_play(GetParam());
  story.roll({-1.0, 0.5}, 2.0);
  story.kick(yellow(4), {-4.85, 1.5}, 5.0);
  story.wait(0.2);
  EXPECT_FALSE(story.saw("icing"));
  EXPECT_EQ(story.rows(), "T11.7");
}

// --- Collisions ---

TEST_P(OffenceScenario, RunningIntoAnOpponentIsADirectFreeKick) {
  Story story = in_play(GetParam());
  story.drive({{yellow(4), {1.325, 1.56}, 2.5}});  // blue 4 stands at (1.5, 1.56)
  story.wait(0.2);
  expect_stopped_by(story, "T11.4", CommandKind::Direct, Team::Blue, yellow(4));
  expect_place(story, {1.41, 1.56});
}

TEST_P(OffenceScenario, TheFasterRobotIsToBlame) {
  Story story = in_play(GetParam());
  story.drive({{yellow(4), {-0.5, 1.56}, 0.9}, {blue(4), {-0.5, 1.56}, 2.0}});
  story.wait(0.2);
  expect_stopped_by(story, "T11.4", CommandKind::Direct, Team::Yellow, blue(4));
}

TEST_P(OffenceScenario, ASlowBumpIsPlayedOn) {
  Story story = in_play(GetParam());
  story.drive({{yellow(4), {1.325, 1.56}, 1.5}});
  story.wait(0.2);
  EXPECT_FALSE(story.saw("collision"));
  EXPECT_EQ(story.commands(), "");
}

TEST_P(OffenceScenario, EquallyFastRobotsAreBothToBlameAndPlayGoesOn) {
  Story story = in_play(GetParam());
  story.drive({{yellow(4), {-0.09, 1.56}, 1.25}, {blue(4), {0.09, 1.56}, 1.25}});
  story.wait(0.2);
  EXPECT_TRUE(story.saw("collision, drawn"));
  EXPECT_FALSE(story.saw("collision"));
  EXPECT_EQ(story.commands(), "");
  EXPECT_EQ(story.last_call().row, "note");
}

TEST_P(OffenceScenario, RobotsThatPassEachOtherDoNotCollide) {
  Story story = in_play(GetParam());
  story.drive({{yellow(4), {2.5, 1.33}, 2.8}});  // 0.05 m between the hulls at the nearest
  story.wait(0.2);
  EXPECT_FALSE(story.saw("collision"));
  EXPECT_FALSE(story.saw("collision, drawn"));
}

TEST_P(OffenceScenario, TeamMatesMayRunIntoEachOther) {
  Story story = in_play(GetParam());
  story.drive({{yellow(4), {-2.0, 0.7}, 2.5}});  // yellow 3 stands at (-2, 0.52)
  story.wait(0.2);
  EXPECT_FALSE(story.saw("collision"));
  EXPECT_EQ(story.commands(), "");
}

TEST_P(OffenceScenario, ACollisionInTheOwnAreaIsAPenalty) {
  Story story = in_play(GetParam());
  story.put(blue(4), {-3.9, 0.52});
  story.wait(1);
  story.drive({{yellow(3), {-3.725, 0.52}, 2.5}});
  story.wait(0.2);
  expect_stopped_by(story, "T11.5", CommandKind::Penalty, Team::Blue, yellow(3));
}

TEST_P(OffenceScenario, PlayGoesOnWhenTheVictimsTeamHasTheBall) {
  Story story = in_play(GetParam());
  story.put(yellow(4), {0.0, 1.56});
  story.kick(blue(2), {1.0, 0.0}, 2.0);
  story.drive({{yellow(4), {1.325, 1.56}, 2.5}});
  story.wait(0.2);
  EXPECT_TRUE(story.saw("collision"));
  EXPECT_EQ(story.commands(), "");
  EXPECT_NE(story.last_call().sentence.find("advantage"), std::string::npos) << story.last_call().sentence;
}

// --- The goalie ---

TEST_P(OffenceScenario, TouchingTheGoalieInItsAreaIsAnIndirectFreeKick) {
  Story story = in_play(GetParam());
  story.put(blue(0), {4.0, 0.6});
  story.put(yellow(4), {3.4, 0.6});
  story.wait(1);
  story.drive({{yellow(4), {3.83, 0.6}, 0.6}});
  story.wait(0.2);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(4));
  expect_place(story, {3.9, 2.9});
}

TEST_P(OffenceScenario, StandingNearTheGoalieIsNoContact) {
  Story story = in_play(GetParam());
  story.put(blue(0), {4.0, 0.6});
  story.put(yellow(4), {3.4, 0.6});
  story.wait(1);
  story.drive({{yellow(4), {3.78, 0.6}, 0.6}});
  story.wait(1);
  EXPECT_FALSE(story.saw("touched the goalie"));
}

TEST_P(OffenceScenario, OtherDefendersAndGoaliesOutsideTheirAreaMayBeTouched) {
  Story story = in_play(GetParam());
  story.put(blue(0), {2.5, 0.6});
  story.put(blue(1), {4.0, 0.6});
  story.put(yellow(4), {3.4, 0.6});
  story.put(yellow(5), {1.9, 0.6});
  story.wait(1);
  story.drive({{yellow(4), {3.83, 0.6}, 0.6}, {yellow(5), {2.33, 0.6}, 0.6}});
  story.wait(1);
  EXPECT_FALSE(story.saw("touched the goalie"));
}

TEST_P(OffenceScenario, AGoalieMayHoldTheBallFifteenSecondsOnly) {
  Story story = in_play(GetParam());
  story.put(yellow(0), {-3.9445, 0.3});
  story.wait(1);
  story.roll({-3.85, 0.3}, 2.0);
  story.wait(14.5);
  EXPECT_EQ(story.commands(), "");  // nor is the ball stuck
  story.wait(1.5);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(0));
}

TEST_P(OffenceScenario, AGoalieThatLetsGoInBetweenMayHoldItAgain) {
  Story story = in_play(GetParam());
  story.put(yellow(0), {-3.9445, 0.3});
  story.wait(1);
  story.roll({-3.85, 0.3}, 2.0);
  story.wait(9);
  story.roll({-3.3, 0.3}, 1.0);
  story.wait(0.6);
  story.roll({-3.85, 0.3}, 1.0);
  story.wait(9);
  EXPECT_EQ(story.commands(), "");
}

// --- Defense areas ---

TEST_P(OffenceScenario, ADefenderWhollyInItsAreaGivesAPenaltyAway) {
  Story story = in_play(GetParam());
  story.roll({-4.0, 0.3}, 2.0);
  story.kick(yellow(3), {-2.7, 0.3}, 3.0);
  story.wait(0.2);
  expect_stopped_by(story, "T11.5", CommandKind::Penalty, Team::Blue, yellow(3));
}

TEST_P(OffenceScenario, ADefenderPartlyInItsAreaGivesAnIndirectFreeKickAway) {
  Story story = in_play(GetParam());
  story.roll({-3.42, 0.3}, 2.0);  // the robot's centre is 0.01 m outside
  story.kick(yellow(3), {-2.4, 0.3}, 3.0);
  story.wait(0.2);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(3));
}

TEST_P(OffenceScenario, ADefenderBesideItsAreaMayPlayTheBall) {
  Story story = in_play(GetParam());
  story.roll({-3.25, 0.3}, 2.0);  // the hull is 0.06 m outside
  story.kick(yellow(3), {-2.3, 0.3}, 3.0);
  story.wait(0.2);
  EXPECT_FALSE(story.saw("defender in own area"));
  EXPECT_EQ(story.commands(), "");
}

TEST_P(OffenceScenario, TheGoalieMayPlayTheBallInItsArea) {
  Story story = in_play(GetParam());
  story.roll({-4.0, 0.3}, 2.0);
  story.kick(yellow(0), {-2.7, 0.3}, 3.0);
  story.wait(0.2);
  EXPECT_FALSE(story.saw("defender in own area"));
  EXPECT_EQ(story.commands(), "");
}

TEST_P(OffenceScenario, AnAttackerMayNotPlayTheBallInTheOpponentsArea) {
  Story story = in_play(GetParam());
  story.roll({3.7, 0.3}, 2.0);
  story.kick(yellow(4), {3.0, 1.3}, 3.0);
  story.wait(0.2);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(4));
}

TEST_P(OffenceScenario, AnAttackerOutsideMayPlayABallInsideTheArea) {
  Story story = in_play(GetParam());
  story.roll({3.35, 0.3}, 2.0);  // the hull is 0.05 m outside
  story.kick(yellow(4), {4.2, 0.5}, 2.0);
  story.wait(0.2);
  EXPECT_FALSE(story.saw("attacker in area"));
  EXPECT_EQ(story.commands(), "");
}

// --- Under STOP ---

// The ball is out over a touch line and has been put back; yellow 2 moves about, so that nothing is settled.
Story stopped(const View& view) {
  Story story = in_play(view);
  story.keep_robots();
  story.kick(blue(3), {0.5, 3.3});
  story.put(blue(3), {2.0, 0.52});
  EXPECT_EQ(story.commands(), "STOP");
  story.drive({{yellow(2), {-1.5, -1.12}, 1.0}});
  story.drive({{yellow(2), {-1.5, -0.52}, 1.0}});
  story.drive({{yellow(2), {-1.5, -1.12}, 1.0}});
  EXPECT_EQ(story.state().location, Location::GameOff);
  return story;
}

TEST_P(OffenceScenario, DrivingFastUnderStopIsSeen) {
  Story story = stopped(GetParam());
  story.drive({{yellow(2), {-1.5, -0.52}, 1.0}});
  story.drive({{yellow(4), {0.5, 1.56}, 2.0}});
  EXPECT_TRUE(story.saw("too fast in stop"));
}

TEST_P(OffenceScenario, DrivingAtTheLimitUnderStopAndBrakingLateAreFine) {
  Story story = in_play(GetParam());
  story.keep_robots();
  story.kick(blue(3), {0.5, 3.3});
  story.drive({{yellow(4), {1.0, 1.0}, 2.8}});  // the first second
  story.drive({{yellow(4), {-1.5, 1.56}, 1.45}});
  story.drive({{yellow(4), {1.0, 1.0}, 1.45}});
  EXPECT_FALSE(story.saw("too fast in stop"));
}

TEST_P(OffenceScenario, StayingNearTheBallUnderStopIsNoted) {
  Story story = in_play(GetParam());
  story.keep_robots();
  story.kick(blue(3), {0.5, 3.3});
  story.put(blue(3), {0.5, 2.45});  // its hull is 0.36 m from where the ball goes
  for (int i = 0; i < 10; ++i) story.drive({{yellow(2), {-1.5, i % 2 == 0 ? -1.12 : -0.52}, 1.0}});
  EXPECT_TRUE(story.saw("too near in stop"));
  EXPECT_EQ(story.last_call().row, "note");
  EXPECT_TRUE(story.last_call().offender == story.seen(blue(3)));
}

TEST_P(OffenceScenario, KeepingHalfAMetreAwayUnderStopIsFine) {
  Story story = in_play(GetParam());
  story.keep_robots();
  story.kick(blue(3), {0.5, 3.3});
  story.put(blue(3), {0.5, 2.29});  // its hull is 0.52 m away
  for (int i = 0; i < 10; ++i) story.drive({{yellow(2), {-1.5, i % 2 == 0 ? -1.12 : -0.52}, 1.0}});
  EXPECT_FALSE(story.saw("too near in stop"));
}

TEST_P(OffenceScenario, StandingInTheWayOfThePlacementIsNoted) {
  Story story = in_play(GetParam());
  story.keep_robots();
  story.refuse_placement();
  story.kick(blue(3), {0.5, 3.3});
  story.put(blue(3), {0.5, 2.6});
  story.wait(3);
  EXPECT_TRUE(story.saw("interfered placement"));
}

TEST_P(OffenceScenario, AFreeWayToThePlaceIsNoInterference) {
  Story story = in_play(GetParam());
  story.keep_robots();
  story.refuse_placement();
  story.kick(blue(3), {0.5, 3.3});
  story.put(blue(3), {0.5, 2.29});
  story.wait(3);
  EXPECT_FALSE(story.saw("interfered placement"));
}

// --- Robots outside, robots too many ---

TEST_P(OffenceScenario, StayingOutsideTheFieldIsNoted) {
  Story story = in_play(GetParam());
  story.drive({{yellow(0), {-1.5, -3.35}, 1.0}});
  story.wait(2.2);
  EXPECT_TRUE(story.saw("robot left field"));
  EXPECT_EQ(story.commands(), "");
}

TEST_P(OffenceScenario, ARobotThatStaysOutsideIsNotedOnce) {
  Story story = in_play(GetParam());
  story.keep_robots();
  story.drive({{yellow(0), {-1.5, -3.35}, 1.0}});
  story.wait(2.2);
  EXPECT_TRUE(story.saw("robot left field"));
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {0.5, 0.0}, 2.0);
  ASSERT_EQ(story.state().location, Location::GameOn);
  story.wait(3);
  EXPECT_FALSE(story.saw("robot left field"));
}

TEST_P(OffenceScenario, ADetourThroughTheRunOffIsFine) {
  Story story = in_play(GetParam());
  story.drive({{yellow(0), {-1.5, -3.35}, 1.0}});  // beyond it for a second
  story.wait(1);
  story.drive({{yellow(0), {-1.5, -3.2}, 1.0}});  // still outside the lines, where robots may drive
  story.wait(3);
  EXPECT_FALSE(story.saw("robot left field"));
}

TEST_P(OffenceScenario, ASeventhRobotIsNoted) {
  Story story = in_play(GetParam());
  story.add(yellow(9), {-0.5, -2.0});
  story.wait(3.5);
  EXPECT_TRUE(story.saw("too many robots"));
  EXPECT_EQ(story.commands(), "");
}

TEST_P(OffenceScenario, SixRobotsAreNeverTooMany) {
  Story story = in_play(GetParam());
  for (int i = 0; i < 10; ++i) story.roll({0.5, i % 2 == 0 ? 0.6 : 0.0}, 0.5);
  EXPECT_FALSE(story.saw("too many robots"));
  EXPECT_EQ(story.commands(), "");
}

INSTANTIATE_TEST_SUITE_P(Views, OffenceScenario, ::testing::ValuesIn(all_views()), view_name);
INSTANTIATE_TEST_SUITE_P(Harsh, OffenceScenario, ::testing::ValuesIn(harsh_views()), view_name);

// --- Chip goals; heights are told exactly ---

class ChipScenario : public Scenario {};

TEST_P(ChipScenario, AChipStraightIntoTheGoalIsNone) {
  Story story = in_play(GetParam());
  const Vector2d from = story.ball();
  story.chip(yellow(4), {4.2, 0}, 0.5, 5.0);
  story.roll({4.65, 0}, 5.0);
  story.wait(0.3);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(4));
  expect_place(story, from);
  EXPECT_EQ(story.score(Team::Yellow), 0);
}

TEST_P(ChipScenario, ALowHopIsAGoal) {
  Story story = in_play(GetParam());
  story.chip(yellow(4), {4.2, 0}, 0.10, 5.0);  // its top is 0.143 m high
  story.roll({4.65, 0}, 5.0);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "GOAL(yellow)");
}

TEST_P(ChipScenario, ABallThatRolledAfterTheChipIsAGoal) {
  Story story = in_play(GetParam());
  story.chip(yellow(4), {2.5, 0}, 0.5, 5.0);
  story.roll({4.65, 0}, 3.0);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "GOAL(yellow)");
}

TEST_P(ChipScenario, ABallThatATeamMateShotAfterTheChipIsAGoal) {
  Story story = in_play(GetParam());
  story.chip(yellow(4), {3.0, 0}, 0.5, 5.0);
  story.kick(yellow(5), {4.65, 0}, 8.0);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "GOAL(yellow)");
}

TEST_P(ChipScenario, ADefenderTouchingItChangesNothing) {
  Story story = in_play(GetParam());
  story.chip(yellow(4), {4.2, 0}, 0.5, 5.0);
  story.touch(blue(2));
  story.roll({4.65, 0}, 5.0);
  story.wait(0.3);
  expect_stopped_by(story, "T11.3", CommandKind::Indirect, Team::Blue, yellow(4));
}

TEST_P(ChipScenario, AChipIntoTheOwnGoalCounts) {
  Story story = in_play(GetParam());
  story.chip(yellow(4), {-4.2, 0}, 0.5, 5.0);
  story.roll({-4.65, 0}, 5.0);
  story.wait(0.3);
  EXPECT_EQ(story.commands(), "GOAL(blue)");
}

INSTANTIATE_TEST_SUITE_P(Views, ChipScenario, ::testing::ValuesIn(all_views()), view_name);

// --- Rule sets ---

class RuleSetScenario : public Scenario {};

TEST_P(RuleSetScenario, ThePaperKnowsNoCollisionsAreasOrIcing) {
  Story story = in_play(GetParam(), "paper");
  story.drive({{yellow(4), {1.325, 1.56}, 2.5}});
  story.roll({-4.0, 0.3}, 2.0);
  story.kick(yellow(3), {-2.7, 0.3}, 3.0);
  EXPECT_EQ(story.commands(), "");
  story.kick(yellow(3), {4.85, 1.5}, 5.0);
  EXPECT_EQ(story.rows(), "T11.7");
}

INSTANTIATE_TEST_SUITE_P(Views, RuleSetScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
