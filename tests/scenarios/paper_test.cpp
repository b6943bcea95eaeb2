// The paper's own examples: section 6.3 and Figure 7 (R-6.3-1 to R-6.3-3).
#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using world::Location;

class PaperScenario : public Scenario {};

// Scenario A: blue touches, the ball leaves, yellow never kicks.
TEST_P(PaperScenario, AFreeKickIsNeverTakenAndPlayGoesOnWithANeutralStart) {
  Story story(GetParam());
  story.begin();
  story.commands();
  ASSERT_EQ(story.state().location, Location::GameOn);

  story.kick(blue(3), {0.5, 3.3});
  EXPECT_EQ(story.state().location, Location::GameOff);
  EXPECT_EQ(story.state().call, world::CommandKind::Indirect);
  EXPECT_EQ(story.kick_team(), world::Team::Yellow);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  const double deadline = story.now() + 10;
  EXPECT_NEAR(world::seconds(*story.state().kick_deadline), deadline, 1e-6);
  ASSERT_TRUE(story.wait_for(Location::GameOff, 11));
  EXPECT_NEAR(story.now(), deadline, 1.5 / 60);  // the first frame after it
  EXPECT_EQ(story.state().call, world::CommandKind::Start);
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) STOP START");
}

// Scenario B: yellow scores.
TEST_P(PaperScenario, BAGoalLeadsToAKickoffForTheOtherTeam) {
  Story story(GetParam());
  story.begin();
  story.commands();

  story.kick(yellow(4), {4.65, 0.1});
  story.wait(0.2);
  EXPECT_EQ(story.state().location, Location::GameOff);
  EXPECT_EQ(story.state().call, world::CommandKind::Kickoff);
  EXPECT_EQ(story.kick_team(), world::Team::Blue);
  EXPECT_EQ(story.score(world::Team::Yellow), 1);
  EXPECT_EQ(story.score(world::Team::Blue), 0);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(blue(2), {-0.3, 0});
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_EQ(story.commands(), "GOAL(yellow) KICKOFF(blue) READY");
}

// Scenario C: Figure 7, opening kickoff, short play, exit, indirect kick.
TEST_P(PaperScenario, CAKickoffIsFollowedByPlayAnExitAndAnIndirectFreeKick) {
  Story story(GetParam());
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(1), {0.8, 0.2});
  ASSERT_EQ(story.state().location, Location::GameOn);
  story.kick(yellow(2), {1.5, -3.4});
  EXPECT_EQ(story.state().location, Location::GameOff);
  EXPECT_TRUE(story.reset_position().isApprox(world::Vector2d(story.reset_position().x(), -2.9)));
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(blue(2), {0.5, -1.0});
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY STOP INDIRECT(blue)");
  EXPECT_EQ(story.rows(), "T10 T15.a T12.1 T13 T11.7 T12.4 T13");
}

INSTANTIATE_TEST_SUITE_P(Views, PaperScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
