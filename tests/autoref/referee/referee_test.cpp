#include "autoref/referee/referee.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "autoref/referee/explain.h"

namespace referee {
namespace {

using namespace std::chrono_literals;
using world::Location;
using world::Team;
using world::Time;
using world::Vector2d;

// Four quiet robots and a ball, as two cameras see them.
std::vector<world::Detection> images(std::int64_t tick, Vector2d ball, Vector2d yellow_1 = {-1.0, 1.0}) {
  std::vector<world::Detection> batch;
  for (int camera = 0; camera < 2; ++camera) {
    world::Detection image;
    image.camera = camera;
    image.frame_number = static_cast<std::uint32_t>(tick);
    image.t_capture = world::whole_microseconds(world::tick_time(tick, camera + 1));
    image.t_sent = image.t_capture;
    image.balls.push_back({.position = ball});
    image.robots.push_back({.team = Team::Yellow, .number = 1, .position = yellow_1, .orientation = 0.0});
    image.robots.push_back({.team = Team::Yellow, .number = 2, .position = {-2.0, -1.0}, .orientation = 0.0});
    image.robots.push_back({.team = Team::Blue, .number = 1, .position = {1.0, 1.0}, .orientation = 3.0});
    image.robots.push_back({.team = Team::Blue, .number = 2, .position = {2.0, -1.0}, .orientation = 3.0});
    batch.push_back(image);
  }
  return batch;
}

Output run(Referee& referee, std::int64_t from, std::int64_t to, Vector2d ball = {0, 0}) {
  Output output;
  for (std::int64_t tick = from; tick < to; ++tick) output = referee.update(images(tick, ball));
  return output;
}

TEST(Referee, LeadsFromTheFirstStopToReady) {
  Referee referee({});
  const Output first = referee.update(images(1, {0, 0}));
  EXPECT_TRUE(first.message_changed);
  ASSERT_EQ(first.calls.size(), 1u);
  EXPECT_EQ(first.calls[0].row, "T10");
  ASSERT_TRUE(first.ball_reset);
  EXPECT_EQ(*first.ball_reset, Vector2d(0, 0));
  EXPECT_EQ(referee.message().designated_position, Vector2d(0, 0));
  EXPECT_EQ(referee.message().next_command, (world::Command{world::CommandKind::Kickoff, Team::Yellow}));
  run(referee, 2, 150);
  EXPECT_EQ(referee.state().location, Location::Setup);
  EXPECT_EQ(referee.message().command.kind, world::CommandKind::Ready);
  EXPECT_TRUE(referee.message().action_time_left);
  EXPECT_TRUE(referee.message().stage_time_left);
  EXPECT_EQ(referee.message().command_counter, 3u);
}

TEST(Referee, TakesNothingForNothing) {
  Referee referee({});
  for (int i = 0; i < 100; ++i) {
    const Output output = referee.update(std::span<const world::Detection>{});
    EXPECT_TRUE(output.calls.empty());
    EXPECT_FALSE(output.ball_reset);
  }
  EXPECT_EQ(referee.state().location, Location::Init);
}

TEST(Referee, SurvivesAGapARepetitionAndANewClock) {
  Referee referee({});
  run(referee, 1, 60);
  run(referee, 30, 60);      // repeated
  run(referee, 4000, 4100);  // a minute later
  run(referee, 1, 400);      // a new clock
  EXPECT_EQ(referee.loop_defects(), 0);
  EXPECT_NE(referee.state().location, Location::Init);
}

// Bad input: no images, by the receiver's clock.
TEST(Referee, HaltsTheGameWhenVisionStopsAndGoesOnWhenItIsBack) {
  Referee referee({});
  run(referee, 1, 150);
  ASSERT_EQ(referee.state().location, Location::Setup);
  const std::uint32_t commands = referee.state().command_counter;
  std::vector<std::pair<std::int64_t, std::string>> calls;
  const auto note = [&](std::int64_t tick, const Output& output) {
    for (const Call& call : output.calls) {
      EXPECT_TRUE(output.message_changed);
      calls.emplace_back(tick, call.sentence);
    }
  };
  for (std::int64_t tick = 150; tick < 600; ++tick) {
    note(tick, referee.update({}, world::tick_time(tick)));
    EXPECT_EQ(referee.message().command.kind == world::CommandKind::Halt, !calls.empty());
  }
  ASSERT_EQ(calls.size(), 1u);
  EXPECT_EQ(calls[0].first, 150 + 120);  // two seconds after the first tick without
  EXPECT_EQ(calls[0].second, "no camera image for 2.0 s, so the game is halted");
  EXPECT_EQ(referee.message().status, calls[0].second);

  note(600, referee.update(images(600, {0, 0}), world::tick_time(600)));
  ASSERT_EQ(calls.size(), 2u);
  EXPECT_THAT(calls[1].second, ::testing::HasSubstr("next is the kickoff for yellow"));
  EXPECT_EQ(referee.message().command.kind, world::CommandKind::Stop);
  EXPECT_EQ(referee.state().command_counter, commands + 2);
  run(referee, 601, 900);
  EXPECT_EQ(referee.state().location, Location::Setup);
}

// A log has no clock but its images': the calls are those of the game, the halt dated as it was.
TEST(Referee, CallsTheSameWhenTheGapIsOnlySeenAfterwards) {
  Referee live({});
  Referee again({});
  run(live, 1, 150);
  run(again, 1, 150);
  std::vector<std::string> called;
  for (std::int64_t tick = 150; tick < 600; ++tick) {
    for (const Call& call : live.update({}, world::tick_time(tick)).calls)
      called.push_back(format_call(call));
  }
  for (const Call& call : live.update(images(600, {0, 0}), world::tick_time(600)).calls) {
    called.push_back(format_call(call));
  }
  std::vector<std::string> repeated;
  for (const Call& call : again.update(images(600, {0, 0})).calls) repeated.push_back(format_call(call));
  EXPECT_EQ(called.size(), 2u);
  EXPECT_EQ(repeated, called);
  EXPECT_EQ(again.state().stage_end, live.state().stage_end);
}

// Back with a clock that starts anew: the tracker takes three batches to believe it.
TEST(Referee, GoesOnWhenVisionIsBackWithANewClock) {
  Referee referee({});
  run(referee, 3000, 3150);
  ASSERT_EQ(referee.state().location, Location::Setup);
  for (std::int64_t tick = 0; tick < 300; ++tick) referee.update({}, world::tick_time(tick));
  ASSERT_EQ(referee.message().command.kind, world::CommandKind::Halt);
  std::vector<std::string> calls;
  for (std::int64_t tick = 1; tick < 10; ++tick) {
    for (const Call& call : referee.update(images(tick, {0, 0})).calls) calls.push_back(call.sentence);
  }
  ASSERT_EQ(calls.size(), 1u);
  EXPECT_EQ(calls[0], "images are back with a new clock, next is the kickoff for yellow");
  run(referee, 10, 300);
  EXPECT_EQ(referee.state().location, Location::Setup);
  EXPECT_GT(*referee.message().stage_time_left, 590s);
}

TEST(Referee, KnowsNothingOfImagesBeforeTheFirst) {
  Referee referee({});
  for (std::int64_t tick = 0; tick < 1000; ++tick) {
    EXPECT_TRUE(referee.update({}, world::tick_time(tick)).calls.empty());
  }
  EXPECT_EQ(referee.state().location, Location::Init);
}

TEST(Referee, AsksAgainForABallThatIsNotInPlace) {
  Referee referee({});
  run(referee, 1, 10, {1, 1});
  int wishes = 0;
  for (std::int64_t tick = 10; tick < 10 + 3 * 60; ++tick) {
    if (referee.update(images(tick, {1, 1})).ball_reset) ++wishes;
  }
  EXPECT_EQ(wishes, 3);  // once a second
}

TEST(Referee, TellsTheKeeperAndTheRobotsAllowed) {
  referee::Setup setup;
  setup.keeper = {3, 4};
  setup.robots = {5, 6};
  setup.names = {"Ay", "Bee"};
  Referee referee(setup);
  referee.update(images(1, {0, 0}));
  EXPECT_EQ(referee.message().teams.yellow.keeper, 3);
  EXPECT_EQ(referee.message().teams.blue.name, "Bee");
  EXPECT_EQ(referee.message().teams.yellow.max_robots, 5);
  referee.set_keeper(Team::Yellow, 1);
  EXPECT_TRUE(referee.update(images(2, {0, 0})).message_changed);
  EXPECT_EQ(referee.message().teams.yellow.keeper, 1);
  EXPECT_FALSE(referee.update(images(3, {0, 0})).message_changed);
}

TEST(Call, IsOneSentenceAPlayerUnderstands) {
  Referee referee({});
  world::TrackedFrame frame;
  frame.ball = world::TrackedBall{};
  frame.ball->observed = true;
  const auto step = [&](double x, double y) {
    frame.time += 20ms;
    frame.ball->position << x, y, 0;
    return referee.update(frame);
  };
  for (int i = 0; i < 200; ++i) step(0, 0);
  ASSERT_EQ(referee.state().location, Location::Setup);
  frame.robots.push_back({.id = {Team::Yellow, 1}, .position = {-0.1, 0}, .observed = true});
  step(0.2, 0);
  ASSERT_EQ(referee.state().location, Location::GameOn);
  step(1.2, 2.9);  // 3 m in 20 ms is no ball's way, so the exit takes longer to believe
  for (int i = 0; i < 20; ++i) step(1.2, 2.9);
  frame.touches = {{{Team::Yellow, 4}, frame.time + 20ms, {1.2, 2.9}, 1.0}};
  step(1.2, 2.96);
  frame.touches.clear();
  step(1.2, 3.1);
  step(1.2, 3.2);
  const Output output = step(1.2, 3.3);
  ASSERT_EQ(output.calls.size(), 1u);
  EXPECT_EQ(
      output.calls[0].sentence,
      "ball left over the touch line at (1.20, 3.02) m, last touched by yellow 4 0.01 s earlier, so indirect "
      "free kick for blue from (1.20, 2.90) m");
  EXPECT_THAT(format_call(output.calls[0]), ::testing::HasSubstr("T11.7"));
  EXPECT_EQ(format_call(output.calls[0]).find('\n'), std::string::npos);
}

TEST(Describe, NamesTheProbabilityOfTheLastTouchAndItsRival) {
  world::Touch touch;
  touch.robot = {world::Team::Yellow, 4};
  touch.time = world::tick_time(60);
  const auto said = [&](double probability) {
    touch.probability = probability;
    return describe({world::tick_time(120), world::BallLeftFieldTouchLine{touch, {1, 3.02}}});
  };
  const std::string begin =
      "ball left over the touch line at (1.00, 3.02) m, last touched by yellow 4 1.00 s earlier";
  touch.rival = world::RobotId{world::Team::Blue, 2};
  EXPECT_EQ(said(1), begin);  // of those who give none
  EXPECT_EQ(said(0.97), begin + " (probability 0.97)");
  EXPECT_EQ(said(0.9999), begin + " (probability 0.99)");  // never certain
  EXPECT_EQ(said(0.6), begin + " (probability 0.60, else blue 2)");
}

}  // namespace
}  // namespace referee
