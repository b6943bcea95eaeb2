// The operator's overrides (R-8-7): each done, reported with who and why, and play goes on correctly after
// it; each also asked for where it makes no sense.
#include <gmock/gmock.h>

#include "tests/scenarios/scenario.h"

namespace scenarios {
namespace {

using namespace std::chrono_literals;
using ::testing::HasSubstr;
using enum world::CommandKind;
using world::Command;
using world::Location;
using world::Stage;
using world::Team;
using world::Vector2d;

class OverrideScenario : public Scenario {};

template <class What>
std::string overrule(Story& story, What what) {
  return story.referee().overrule({"Ann", "seen from the touch line", what});
}

// Does it, and expects the call of it in the next tick.
template <class What>
void expect_done(Story& story, What what) {
  ASSERT_EQ(overrule(story, what), "");
  const std::size_t calls = story.calls().size();
  story.tick();
  ASSERT_GT(story.calls().size(), calls);
  const referee::Call& call = story.calls()[calls];
  EXPECT_EQ(call.row, "override");
  EXPECT_THAT(call.sentence, HasSubstr("Ann "));
  EXPECT_THAT(call.sentence, HasSubstr("(seen from the touch line)"));
  EXPECT_EQ(format_call(call).find('\n'), std::string::npos);
}

// Expects a refusal with these words, and that nothing whatever has changed.
template <class What>
void expect_refused(Story& story, What what, const std::string& words) {
  const world::GameState before = story.state();
  EXPECT_THAT(overrule(story, what), HasSubstr(words));
  const world::GameState& after = story.state();
  EXPECT_EQ(after.location, before.location);
  EXPECT_EQ(after.stage, before.stage);
  EXPECT_EQ(after.command_counter, before.command_counter);
  EXPECT_EQ(after.reset_position, before.reset_position);
  EXPECT_EQ(after.score, before.score);
  EXPECT_EQ(after.call, before.call);
  EXPECT_EQ(after.kick_team, before.kick_team);
  EXPECT_EQ(after.yellow_times, before.yellow_times);
  EXPECT_EQ(after.red_cards, before.red_cards);
  const std::size_t calls = story.calls().size();
  story.tick();
  for (std::size_t i = calls; i < story.calls().size(); ++i) EXPECT_NE(story.calls()[i].row, "override");
}

Story in_play(const View& view) {
  Story story(view);
  story.begin();
  story.commands();
  story.rows();
  return story;
}

// --- Reverse ---

TEST_P(OverrideScenario, AGoalIsReversed) {
  Story story = in_play(GetParam());
  story.kick(yellow(4), {4.65, 0.1});
  story.wait(0.2);
  ASSERT_EQ(story.score(Team::Yellow), 1);
  expect_done(story, referee::ReverseLastCall{});
  EXPECT_EQ(story.score(Team::Yellow), 0);
  EXPECT_THAT(story.last_call().sentence, HasSubstr("goal for"));
  EXPECT_EQ(story.referee().message().status, story.last_call().sentence);
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "GOAL(yellow) STOP START");
  EXPECT_EQ(story.referee().message().status.substr(0, 6), "rules=");
  // Play is on as usual: the next goal counts.
  story.put_ball({2, 0});
  story.kick(yellow(4), {4.65, 0.1});
  story.wait(0.2);
  EXPECT_EQ(story.score(Team::Yellow), 1);
}

TEST_P(OverrideScenario, AnExitIsReversedWhileTheKickIsDue) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  expect_done(story, referee::ReverseLastCall{});
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) STOP START");
}

TEST_P(OverrideScenario, ARetakeIsReversedIntoTheKickThatWasStopped) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.put(yellow(4), {4.5 - 1.0 - 0.09 - 0.15, 0});
  story.kick(yellow(3), {-0.5, 2.0});
  ASSERT_EQ(story.kick_team(), Team::Blue);  // T18.b gave the kick away
  expect_done(story, referee::ReverseLastCall{});
  EXPECT_EQ(story.kick_team(), Team::Yellow);
  EXPECT_LT((story.reset_position() - Vector2d(0.5, 2.9)).norm(), 1e-6);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) STOP STOP INDIRECT(yellow)");
}

TEST_P(OverrideScenario, ThereIsNothingToReverse) {
  Story story(GetParam());
  story.wait(0.1);
  expect_refused(story, referee::ReverseLastCall{}, "none has stopped play yet");
  story.begin();
  expect_refused(story, referee::ReverseLastCall{}, "none has stopped play yet");
  story.kick(blue(3), {0.5, 3.3});
  expect_done(story, referee::ReverseLastCall{});
  expect_refused(story, referee::ReverseLastCall{}, "reversed already");
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  story.put_ball({0, 0});
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {-0.5, 2.0});
  ASSERT_EQ(story.state().location, Location::GameOn);
  expect_refused(story, referee::ReverseLastCall{}, "restarted");
}

// --- Commands ---

TEST_P(OverrideScenario, PlayIsStoppedAndGoesOnWithANeutralStart) {
  Story story = in_play(GetParam());
  expect_done(story, referee::ForceCommand{Command{Stop}});
  EXPECT_EQ(story.state().location, Location::GameOff);
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "STOP START");
}

TEST_P(OverrideScenario, AFreeKickIsOrdered) {
  Story story = in_play(GetParam());
  expect_done(story, referee::ForceCommand{Command{Direct, story.seen(Team::Blue)}});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(blue(2), {-1, 0.5});
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_EQ(story.commands(), "STOP DIRECT(blue)");
  EXPECT_EQ(story.rows(), "T12.3 T13");
}

TEST_P(OverrideScenario, AnotherKickIsOrderedInsteadOfTheOneThatWasCalled) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  story.tick();
  expect_done(story, referee::ForceCommand{Command{Indirect, story.seen(Team::Blue)}});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP INDIRECT(blue)");
  EXPECT_LT((story.reset_position() - Vector2d(0.5, 2.9)).norm(), 1e-6);
}

TEST_P(OverrideScenario, TheKickThatIsDueIsSentAtOnce) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  story.put(yellow(5), {0, 2.5});
  expect_done(story, referee::ForceCommand{Command{Indirect, story.seen(Team::Yellow)}});
  EXPECT_EQ(story.state().location, Location::Setup);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow)");
}

TEST_P(OverrideScenario, APenaltyAndAKickoffAreOrdered) {
  Story story = in_play(GetParam());
  expect_done(story, referee::ForceCommand{Command{Penalty, story.seen(Team::Yellow)}});
  EXPECT_LT((story.reset_position() - Vector2d(3.5, 0)).norm(), 1e-6);
  expect_done(story, referee::ForceCommand{Command{Kickoff, story.seen(Team::Blue)}});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP KICKOFF(blue) READY");
}

TEST_P(OverrideScenario, ReadyAndStartAreSentAtOnce) {
  Story story(GetParam());
  story.wait(0.1);
  expect_refused(story, referee::ForceCommand{Command{Ready}}, "none has been announced");
  expect_refused(story, referee::ForceCommand{Command{Start}}, "no neutral start");
  expect_done(story, referee::ForceCommand{Command{Kickoff, story.seen(Team::Yellow)}});
  expect_done(story, referee::ForceCommand{Command{Ready}});
  EXPECT_EQ(story.state().location, Location::Setup);
  EXPECT_EQ(story.state().stage, Stage::First);
  expect_done(story, referee::ForceCommand{Command{Start}});
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY START");
  expect_refused(story, referee::ForceCommand{Command{Start}}, "play is on already");
}

TEST_P(OverrideScenario, AGoalIsAwarded) {
  Story story = in_play(GetParam());
  expect_done(story, referee::ForceCommand{Command{Goal, story.seen(Team::Blue)}});
  EXPECT_EQ(story.score(Team::Blue), 1);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "GOAL(blue) KICKOFF(yellow) READY");
}

TEST_P(OverrideScenario, ATimeoutIsGiven) {
  Story story = in_play(GetParam());
  const Team team = story.seen(Team::Blue);
  expect_refused(story, referee::ForceCommand{Command{Timeout, team}}, "while play is stopped");
  story.kick(blue(3), {0.5, 3.3});
  expect_done(story, referee::ForceCommand{Command{Timeout, team}});
  EXPECT_EQ(story.state().timeout_num[team], 3);
  story.wait(20);
  story.referee().end_timeout(team);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_NEAR(world::seconds(story.state().timeout_time[team]), 280, 0.1);
  EXPECT_EQ(story.commands(), "STOP TIMEOUT(blue) STOP INDIRECT(yellow)");
}

// --- Score, cards, stage ---

TEST_P(OverrideScenario, TheScoreIsSet) {
  Story story = in_play(GetParam());
  world::PerTeam<int> score{};
  score[story.seen(Team::Yellow)] = 3;
  expect_done(story, referee::SetScore{score});
  EXPECT_EQ(story.score(Team::Yellow), 3);
  EXPECT_EQ(story.state().location, Location::GameOn);  // play goes on meanwhile
  EXPECT_EQ(story.commands(), "");
  expect_refused(story, referee::SetScore{{-1, 0}}, "-1 is impossible");
  expect_refused(story, referee::SetScore{{0, 100}}, "100 is impossible");
}

TEST_P(OverrideScenario, CardsAreSetAndRunOut) {
  Story story = in_play(GetParam());
  const Team team = story.seen(Team::Blue);
  expect_done(story, referee::SetCards{team, 1, {2s, 60s}});
  EXPECT_EQ(story.referee().message().teams[team].max_robots, 3);
  EXPECT_EQ(story.referee().message().teams[team].red_cards, 1);
  EXPECT_EQ(story.referee().message().teams[team].yellow_cards, 2);
  story.wait(2.5);
  story.kick(blue(3), {0.5, 3.3});
  story.tick();
  EXPECT_EQ(story.referee().message().teams[team].max_robots, 4);  // T15.b
  expect_refused(story, referee::SetCards{team, -1, {}}, "impossible");
  expect_refused(story, referee::SetCards{team, 0, {0s}}, "0 s left is impossible");
  expect_refused(story, referee::SetCards{team, 0, {2h}}, "impossible");
  expect_refused(story, referee::SetCards{team, 0, std::vector<world::Duration>(7, 10s)}, "7 yellow");
}

TEST_P(OverrideScenario, TheStageIsSet) {
  Story story = in_play(GetParam());
  const bool ends = story.state().blue_on_positive_half;
  expect_done(story, referee::SetStage{Stage::PreSecond});
  EXPECT_NE(story.state().blue_on_positive_half, ends);
  EXPECT_EQ(story.kick_team(), Team::Blue);
  EXPECT_FALSE(story.state().stage_end);
  expect_refused(story, referee::SetStage{Stage::PreSecond}, "PRE-SECOND already");
  ASSERT_EQ(overrule(story, referee::SetStage{Stage::HalfTime}), "");
  EXPECT_EQ(story.state().blue_on_positive_half, ends);
  EXPECT_EQ(story.state().location, Location::Break);
  story.tick();
  EXPECT_EQ(story.state().stage, Stage::PreSecond);  // half-time takes no time here
  expect_done(story, referee::SetStage{Stage::First});
  EXPECT_NEAR(world::seconds(*story.referee().message().stage_time_left), 600, 0.1);
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(blue(2), {-0.5, 0.5});
  expect_done(story, referee::SetStage{Stage::Post});
  EXPECT_EQ(story.state().location, Location::Break);
  EXPECT_EQ(story.state().command, Command{Halt});
  expect_refused(story, referee::ForceCommand{Command{Start}}, "set the stage first");
  expect_refused(story, referee::Pause{}, "cannot be paused");
  expect_done(story, referee::SetStage{Stage::First});  // a mistake
  ASSERT_TRUE(story.wait_for(Location::GameOn));
}

TEST(Override, TheShootoutIsSet) {
  Story story{View{}};
  story.begin();
  expect_done(story, referee::SetStage{Stage::Shootout});
  EXPECT_EQ(story.kick_team(), Team::Yellow);
  EXPECT_EQ(story.referee().message().teams.yellow.max_robots, 2);
  expect_refused(story, referee::ForceCommand{Command{Direct, Team::Blue}}, "penalty kicks only");
  expect_refused(story, referee::ForceCommand{Command{Start}}, "no neutral start");
}

TEST_P(OverrideScenario, TheMatchMustHaveBegun) {
  Story story(GetParam());
  EXPECT_THAT(overrule(story, referee::SetStage{Stage::Second}), HasSubstr("has not begun"));
  EXPECT_THAT(overrule(story, referee::ForceCommand{Command{Stop}}), HasSubstr("has not begun"));
  EXPECT_THAT(overrule(story, referee::SetScore{{1, 0}}), HasSubstr("has not begun"));
}

// --- The ball ---

TEST_P(OverrideScenario, TheBallIsPutElsewhere) {
  Story story = in_play(GetParam());
  expect_refused(story, referee::SetBallPosition{{0, 0}}, "in play");
  story.kick(blue(3), {0.5, 3.3});
  const Vector2d place = story.turned({1.5, 2.5});
  expect_refused(story, referee::SetBallPosition{{4.6, 0}}, "not on the field");
  expect_refused(story, referee::SetBallPosition{{std::nan(""), 0}}, "not on the field");
  expect_done(story, referee::SetBallPosition{place});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_LT((story.ball() - Vector2d(1.5, 2.5)).norm(), 1e-6);
  // Also when the kick had been signalled.
  expect_done(story, referee::SetBallPosition{story.turned({0.5, 2.5})});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_LT((story.ball() - Vector2d(0.5, 2.5)).norm(), 1e-6);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) STOP INDIRECT(yellow)");
  story.kick(yellow(3), {-0.5, 2.0});
  EXPECT_EQ(story.state().location, Location::GameOn);
}

// --- Pause and resume ---

TEST_P(OverrideScenario, PlayIsPausedWhileTheClockStands) {
  Story story = in_play(GetParam());
  expect_refused(story, referee::Resume{}, "not halted");
  const world::Duration left = *story.referee().message().stage_time_left;
  expect_done(story, referee::Pause{});
  expect_refused(story, referee::Pause{}, "halted already");
  story.wait(100);
  EXPECT_NEAR(world::seconds(*story.referee().message().stage_time_left), world::seconds(left), 0.1);
  EXPECT_EQ(story.commands(), "HALT");
  expect_done(story, referee::Resume{});
  ASSERT_TRUE(story.wait_for(Location::GameOn));
  EXPECT_EQ(story.commands(), "STOP START");
}

TEST_P(OverrideScenario, AKickThatWasDueIsDueAfterThePause) {
  Story story = in_play(GetParam());
  story.kick(blue(3), {0.5, 3.3});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  expect_done(story, referee::ForceCommand{Command{Halt}});
  story.wait(5);
  expect_done(story, referee::Resume{});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  story.kick(yellow(3), {-0.5, 2.0});
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_EQ(story.commands(), "STOP INDIRECT(yellow) HALT STOP INDIRECT(yellow)");
}

TEST_P(OverrideScenario, AKickoffThatWasAnnouncedIsAnnouncedAgainAfterThePause) {
  Story story(GetParam());
  ASSERT_TRUE(story.wait_for(Location::Setup));
  expect_done(story, referee::Pause{});
  expect_done(story, referee::Resume{});
  ASSERT_TRUE(story.wait_for(Location::Setup));
  EXPECT_EQ(story.commands(), "STOP KICKOFF(yellow) READY HALT STOP KICKOFF(yellow) READY");
  story.kick(yellow(1), {1.0, 0});
  EXPECT_EQ(story.state().location, Location::GameOn);
  EXPECT_EQ(story.state().stage, Stage::First);
}

TEST(Override, MustSayWhoAndWhy) {
  Story story{View{}};
  story.begin();
  EXPECT_THAT(story.referee().overrule({"", "why", referee::Pause{}}), HasSubstr("who"));
  EXPECT_THAT(story.referee().overrule({"Ann", "", referee::Pause{}}), HasSubstr("why"));
  EXPECT_THAT(story.referee().overrule({"Ann", "two\nlines", referee::Pause{}}), HasSubstr("one line"));
  EXPECT_EQ(story.state().location, Location::GameOn);
}

INSTANTIATE_TEST_SUITE_P(Views, OverrideScenario, ::testing::ValuesIn(all_views()), view_name);

}  // namespace
}  // namespace scenarios
