// Penalty kicks (R-R15-15), extra time and the shoot-out (R-8-10), cards (R-4.3-10).
#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using world::Command;
using world::Location;
using world::Stage;
using world::Team;
using world::Vector2d;

class PenaltyScenario : public Scenario {};

// Everybody where Law 14 wants them, for a kick at the goal at +x (sign 1) or at -x.
void line_up(Story& story, Team kicking = Team::Yellow, double sign = 1) {
  for (std::uint8_t number = 1; number < 6; ++number) {
    story.put({Team::Yellow, number}, {sign * 2.5, -2.5 + number * 0.5});
    story.put({Team::Blue, number}, {sign * 2.2, -2.5 + number * 0.5});
  }
  story.put({world::opponent(kicking), 0}, {sign * 4.49, 0.2});
  story.put({kicking, 0}, {-sign * 4.0, 0});
  story.put({kicking, 1}, {sign * 3.3, 0});
}

// Yellow's penalty is to be taken.
Story at_penalty(const View& view, double half_length = 600) {
  Story story(view, "ssl-2015", half_length);
  story.begin();
  story.keep_robots();
  EXPECT_EQ(story.referee().overrule(
                {"Ann", "foul in the area",
                 referee::ForceCommand{{world::CommandKind::Penalty, story.seen(Team::Yellow)}}}),
            "");
  line_up(story);
  EXPECT_TRUE(story.wait_for(Location::Setup));
  EXPECT_LT((story.ball() - Vector2d(3.5, 0)).norm(), 1e-6);
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY STOP PENALTY(yellow) READY");
  story.rows();
  return story;
}

TEST_P(PenaltyScenario, AGoalCounts) {
  Story story = at_penalty(GetParam());
  story.kick(yellow(1), {4.65, -0.2}, 5);
  story.wait(0.3);
  EXPECT_EQ(story.rows(), "R15-15.a T11.1");
  EXPECT_EQ(story.score(Team::Yellow), 1);
}

TEST_P(PenaltyScenario, AGoalOffTheKeeperCounts) {
  Story story = at_penalty(GetParam());
  story.kick(yellow(1), {4.3, 0.1}, 5);
  story.touch(blue(0));
  story.roll({4.65, 0.2}, 2);
  story.wait(0.3);
  EXPECT_EQ(story.rows(), "R15-15.a T11.1");
}

TEST_P(PenaltyScenario, AMissIsAGoalKick) {
  Story story = at_penalty(GetParam());
  story.kick(yellow(1), {4.75, -0.9}, 5);
  story.wait(0.2);
  EXPECT_EQ(story.rows(), "R15-15.a T11.7");
  EXPECT_EQ(story.last_call().restart.substr(0, 9), "goal kick");
}

TEST_P(PenaltyScenario, PlayGoesOnAfterASave) {
  Story story = at_penalty(GetParam());
  story.kick(yellow(1), {4.3, 0.1}, 5);
  story.touch(blue(0));
  story.roll({3.0, 1.0}, 2);
  EXPECT_EQ(story.rows(), "R15-15.a");
  story.kick(yellow(2), {4.65, 0}, 5);  // the rebound
  story.wait(0.3);
  EXPECT_EQ(story.rows(), "R15-15.e T11.1");
}

TEST_P(PenaltyScenario, AKeeperOffItsLineMakesAMissBeTakenAgain) {
  Story story = at_penalty(GetParam());
  story.put(blue(0), {4.2, 0});
  story.kick(yellow(1), {4.75, -0.9}, 5);
  story.wait(0.2);
  EXPECT_EQ(story.rows(), "R15-15.a R15-15.b");
  EXPECT_EQ(story.last_call().restart,
            std::string("penalty kick for ") + world::name(story.seen(Team::Yellow)));
  line_up(story);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(1), {4.65, -0.2}, 5);
  story.wait(0.3);
  EXPECT_EQ(story.score(Team::Yellow), 1);
}

TEST_P(PenaltyScenario, ATeamMateOverTheLineMakesAGoalBeTakenAgain) {
  Story story = at_penalty(GetParam());
  story.put(yellow(2), {3.1, 1});
  story.kick(yellow(1), {4.65, -0.2}, 5);
  story.wait(0.3);
  EXPECT_EQ(story.rows(), "R15-15.a R15-15.b");
  EXPECT_EQ(story.score(Team::Yellow), 0);
}

TEST_P(PenaltyScenario, TheSignalWaitsForRobotsInTheWrongPlace) {
  Story story(GetParam());
  story.begin();
  story.keep_robots();
  story.referee().overrule({"Ann", "foul in the area",
                            referee::ForceCommand{{world::CommandKind::Penalty, story.seen(Team::Yellow)}}});
  line_up(story);
  story.put(blue(4), {3.2, 1});  // over the line
  story.wait(10);
  EXPECT_EQ(story.state().location, Location::GameOff);
  EXPECT_EQ(story.state().command.kind, world::CommandKind::Penalty);
  story.put(blue(4), {2.9, 1});
  story.wait(1.2);
  EXPECT_EQ(story.state().location, Location::Setup);
}

TEST_P(PenaltyScenario, APenaltyThatIsNotTakenInTimeIsANeutralStart) {
  Story story = at_penalty(GetParam());
  story.wait(10.1);
  EXPECT_EQ(story.rows(), "T18.a");
}

TEST_P(PenaltyScenario, TimeIsAddedForThePenaltyAndEndsWithIt) {
  Story story = at_penalty(GetParam(), 1);
  ASSERT_LT(*story.referee().message().stage_time_left, world::Duration::zero());
  story.kick(yellow(1), {4.3, 0.1}, 5);
  story.touch(blue(0));
  story.roll({3.9, 0.3}, 2);
  story.wait(0.6);
  EXPECT_EQ(story.rows().substr(0, 31), "R15-15.a R15-15.d T16.a T17.a");
}

// --- Cards ---

TEST_P(PenaltyScenario, CardsLowerTheNumberOfRobotsForTwoMinutesEach) {
  Story story(GetParam());
  story.begin();
  const Team team = story.seen(Team::Blue);
  const auto allowed = [&] { return story.referee().message().teams[team].max_robots; };
  using namespace std::chrono_literals;
  story.referee().overrule({"Ann", "two cautions", referee::SetCards{team, 0, {60s, 120s}}});
  story.tick();
  EXPECT_EQ(allowed(), 4);
  story.kick(blue(3), {0.5, 3.3});
  story.referee().request_timeout(team);
  story.wait(200);  // the time-out does not count
  story.referee().end_timeout(team);
  story.tick();
  EXPECT_EQ(allowed(), 4);
  for (int i = 0; i < 40 && allowed() == 4; ++i)
    story.wait(2);  // kicks are late, neutral starts, stuck balls
  EXPECT_EQ(allowed(), 5);
  EXPECT_LE(story.state().yellow_times[team][0], 60s);
  EXPECT_GT(story.state().yellow_times[team][0], 35s);  // removed at a stoppage, at most 25 s late
}

// --- A game that needs a winner ---

Story at_shootout(const View& view) {
  Story story(view, "ssl-2015", 5, true);
  story.keep_robots();
  for (int half = 0; half < 4; ++half) {
    const double sign = half % 2 == 0 ? 1 : -1;
    for (int i = 0; i < 6; ++i) {
      story.put({Team::Yellow, static_cast<std::uint8_t>(i)}, {-1.5 * sign, i * 0.8 - 2});
      story.put({Team::Blue, static_cast<std::uint8_t>(i)}, {1.5 * sign, i * 0.8 - 2});
    }
    EXPECT_TRUE(story.wait_for(Location::Setup)) << half;
    story.kick(half % 2 == 0 ? yellow(1) : blue(1), {sign * (half % 2 == 0 ? 1.0 : -1.0), 0});
    story.wait(5);
    story.roll({0, 3.4});
    story.wait(0.1);
  }
  return story;
}

TEST_P(PenaltyScenario, ADrawGoesThroughExtraTimeToAShootout) {
  Story story = at_shootout(GetParam());
  EXPECT_EQ(story.state().stage, Stage::Shootout);
  EXPECT_EQ(story.commands(),
            "STOP KICKOFF(yellow) READY STOP HALT KICKOFF(blue) READY STOP HALT "
            "KICKOFF(yellow) READY STOP HALT KICKOFF(blue) READY STOP HALT STOP");
  EXPECT_EQ(story.referee().message().teams.yellow.max_robots, 2);
  EXPECT_EQ(story.referee().message().teams.blue.max_robots, 2);
  EXPECT_EQ(story.kick_team(), Team::Yellow);
}

TEST_P(PenaltyScenario, TheShootoutEndsWhenItIsDecided) {
  Story story = at_shootout(GetParam());
  story.commands();
  const auto kick = [&](bool goal) {
    const Team team = story.kick_team();
    const double sign = team == Team::Yellow ? -1 : 1;  // ends were changed three times
    line_up(story, team, sign);
    ASSERT_TRUE(story.wait_for(Location::Setup)) << "kick of " << world::name(team);
    story.kick({team, 1}, {sign * 4.65, goal ? -0.2 : -0.9}, 5);
    story.wait(0.5);
  };
  for (const bool goal : {true, false, true, true, true, false, false, false}) kick(goal);
  // Yellow 3 of 4, blue 1 of 4: blue cannot catch up.
  EXPECT_EQ(story.state().stage, Stage::Post);
  EXPECT_EQ(story.score(Team::Yellow), 3);
  EXPECT_EQ(story.score(Team::Blue), 1);
  EXPECT_EQ(story.state().location, Location::Break);
  EXPECT_EQ(story.referee().loop_defects(), 0);
  EXPECT_EQ(story.commands(),
            "PENALTY(yellow) READY GOAL(yellow) PENALTY(blue) READY STOP "
            "PENALTY(yellow) READY GOAL(yellow) PENALTY(blue) READY GOAL(blue) "
            "PENALTY(yellow) READY GOAL(yellow) PENALTY(blue) READY STOP "
            "PENALTY(yellow) READY STOP PENALTY(blue) READY STOP HALT");
}

INSTANTIATE_TEST_SUITE_P(Views, PenaltyScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
