// A vision that stops or whose clock jumps: the game is halted, and goes on with what was interrupted.
#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using world::Location;
using world::Stage;
using world::Team;
using world::Vector2d;

class VisionScenario : public Scenario {};

TEST_P(VisionScenario, PlayIsHaltedAfterTwoSecondsAndGoesOnWithANeutralStart) {
  Story story(GetParam());
  story.begin();
  story.commands();
  const double left = world::seconds(*story.referee().message().stage_time_left);
  const double last_seen = story.now();
  story.skip(60);
  story.tick();
  ASSERT_EQ(story.commands(), "HALT STOP");
  const std::size_t calls = story.calls().size();
  EXPECT_EQ(story.calls()[calls - 2].row, "vision");
  EXPECT_NEAR(world::seconds(story.calls()[calls - 2].time), last_seen + 2, 1e-6);
  EXPECT_EQ(story.calls()[calls - 2].sentence, "no camera image for 2.0 s, so the game is halted");
  EXPECT_EQ(story.calls()[calls - 1].sentence, "images are back after 60.0 s, next is the neutral start");
  // Two seconds of the half are gone, not sixty (I-40).
  EXPECT_NEAR(world::seconds(*story.referee().message().stage_time_left), left - 2, 0.05);
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "START");
}

TEST_P(VisionScenario, AGapOfLessThanTwoSecondsIsNothing) {
  Story story(GetParam());
  story.begin();
  story.commands();
  story.skip(1.9);
  story.tick();
  EXPECT_EQ(story.commands(), "");
  EXPECT_EQ(story.state().location, Location::GameOn);
}

TEST_P(VisionScenario, AFreeKickThatWasDueIsDueAgain) {
  Story story(GetParam());
  story.begin();
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.commands();
  story.skip(30);
  story.tick();
  EXPECT_EQ(story.kick_team(), Team::Yellow);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "HALT STOP INDIRECT(yellow)");
  EXPECT_LT((story.reset_position() - Vector2d(0.5, 2.9)).norm(), 1e-6);
}

TEST_P(VisionScenario, AKickoffThatWasAnnouncedIsAnnouncedAgain) {
  Story story(GetParam());
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.skip(5);
  ASSERT_TRUE(story.wait_for(Location::GameOff));
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY HALT STOP KICKOFF(yellow) READY");
}

TEST_P(VisionScenario, ATimeoutRunsOnUnseen) {
  Story story(GetParam());
  story.begin();
  story.kick(blue(3), {0.5, 3.3});
  story.referee().request_timeout(story.seen(Team::Blue));
  story.tick();
  ASSERT_EQ(story.state().location, Location::Break);
  story.commands();
  story.skip(30);
  story.tick();
  EXPECT_EQ(story.commands(), "");
  EXPECT_NEAR(world::seconds(story.state().timeout_time[story.seen(Team::Blue)]), 270, 0.1);
}

TEST_P(VisionScenario, AClockThatJumpsBackMovesTheWholeGameWithIt) {
  Story story(GetParam());
  story.wait(30);  // kicks are late, neutral starts
  story.begin();
  story.commands();
  const double left = world::seconds(*story.referee().message().stage_time_left);
  story.skip(-25);
  story.tick();
  EXPECT_EQ(story.commands(), "");
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_NEAR(world::seconds(*story.referee().message().stage_time_left), left, 0.05);
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow)");
}

INSTANTIATE_TEST_SUITE_P(Views, VisionScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
