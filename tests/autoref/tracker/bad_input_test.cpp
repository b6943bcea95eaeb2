#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/autoref/tracker/running.h"

namespace tracker {
namespace {

TEST(Tracker, SurvivesNonsense) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  world::RandomStream chaos(9, "chaos");
  const Game game(5, 12);
  const double bad[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e9, 0, 49.9};
  const auto bad_value = [&] { return bad[chaos.below(6)]; };
  world::Time last{world::Duration{-1}};
  int frames = 0;
  for (std::int64_t tick = 1; tick <= 600; ++tick) {
    auto images = cameras.images(tick, std::cref(game));
    for (auto& image : images) {
      if (chaos.below(4) == 0) image.balls.push_back({.position = {bad_value(), bad_value()}});
      if (chaos.below(20) == 0) {
        for (int n = 0; n < 50; ++n) {
          image.balls.push_back({.position = {9 * chaos.uniform() - 4.5, 6 * chaos.uniform() - 3}});
        }
      }
      for (int n = 0; n < 3; ++n) {
        world::DetectedRobot robot;
        robot.team = static_cast<Team>(chaos.below(3));  // also a team that does not exist
        if (chaos.below(5) != 0) robot.number = static_cast<std::uint8_t>(chaos.below(256));
        robot.position =
            chaos.below(3) == 0 ? Vector2d(bad_value(), 0) : Vector2d(9 * chaos.uniform() - 4.5, 0);
        if (chaos.below(3) != 0) robot.orientation = bad_value();
        robot.confidence = bad_value();
        image.robots.push_back(robot);
      }
      if (chaos.below(50) == 0) image.camera = static_cast<int>(chaos.below(1'000'000)) - 500'000;
      if (chaos.below(50) == 0) image.t_capture -= std::chrono::milliseconds(30);
      if (chaos.below(100) == 0)
        image.t_capture = world::Time{world::Duration{std::numeric_limits<std::int64_t>::min()}};
      if (chaos.below(100) == 0) image.t_capture -= std::chrono::hours(5);
      if (chaos.below(100) == 0) image.t_capture += std::chrono::hours(5);
    }
    if (chaos.below(10) == 0) images.push_back(images[0]);
    if (chaos.below(30) == 0) images.clear();
    if (const world::TrackedFrame* frame = tracker.update(images)) {
      ++frames;
      ASSERT_TRUE(is_finite(*frame));
      ASSERT_GT(frame->time, last);
      last = frame->time;
      ASSERT_TRUE(std::ranges::is_sorted(frame->robots, {}, &world::TrackedRobot::id));
    }
  }
  EXPECT_GT(frames, 500);
  EXPECT_EQ(tracker.restarts(), 0);
  // The game itself is still followed.
  const world::TrackedFrame& frame = tracker.frame();
  const double t = world::seconds(frame.time);
  for (std::uint8_t n = 0; n < 6; ++n) {
    const auto* robot = world::find_robot(frame, {Team::Yellow, n});
    ASSERT_NE(robot, nullptr);
    EXPECT_LT((robot->position - game.robots[n].position(t)).norm(), 0.01);
  }
}

TEST(Tracker, JumpForwardIsBelievedAtOnce) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const Motion motion = standing(Vector2d(1, 1), {{yellow_3, {2, 1}, 1}});
  run(tracker, cameras, 1, 30, motion);
  run(tracker, cameras, 900, 900, motion);
  EXPECT_EQ(tracker.frame().time, world::whole_microseconds(world::tick_time(900)));
  run(tracker, cameras, 901, 903, motion);
  EXPECT_EQ(tracker.frame().robots.size(), 1u);
  EXPECT_TRUE(tracker.frame().ball);
}

TEST(Tracker, LogThatStartsAgainStartsTheTrackerAgain) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const Motion motion = standing(Vector2d(1, 1), {{yellow_3, {2, 1}, 1}});
  run(tracker, cameras, 600, 700, motion);
  EXPECT_EQ(tracker.update(cameras.images(1, motion)), nullptr);
  EXPECT_EQ(tracker.update(cameras.images(2, motion)), nullptr);
  EXPECT_EQ(tracker.restarts(), 0);
  run(tracker, cameras, 3, 6, motion);  // the third batch is believed
  EXPECT_EQ(tracker.restarts(), 1);
  EXPECT_EQ(tracker.frame().robots.size(), 1u);
}

TEST(Tracker, OneOldPacketDoesNotStartItAgain) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const Motion motion = standing(Vector2d(1, 1), {{yellow_3, {2, 1}, 1}});
  run(tracker, cameras, 600, 700, motion);
  for (std::int64_t tick = 701; tick < 720; ++tick) {
    EXPECT_EQ(tracker.update(cameras.images(tick - 500, motion)), nullptr);
    EXPECT_NE(tracker.update(cameras.images(tick, motion)), nullptr);
  }
  EXPECT_EQ(tracker.restarts(), 0);
}

TEST(Tracker, ImagesThatComeLateStillCountForTheirCamera) {
  // Camera 0 is always delivered one tick late, so its captures are older than the last frame.
  const synthetic::GameRobot truth(11, 3);
  const Motion motion = [&](double t) {
    return Scene{std::nullopt, {{yellow_3, Vector2d(-3, -2) + truth.position(t) * 0.2, 0}}};
  };
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  std::vector<world::Detection> held;
  for (std::int64_t tick = 1; tick <= 60; ++tick) {
    auto images = cameras.images(tick, motion);
    const world::Detection late = images[0];
    images.erase(images.begin());
    images.insert(images.end(), held.begin(), held.end());
    held = {late};
    tracker.update(images);
  }
  ASSERT_EQ(tracker.frame().robots.size(), 1u);
  const double t = world::seconds(tracker.frame().time);
  // One frame of foretelling at up to 6 m/s^2 x 0.2: 0.3 mm more than noise.
  EXPECT_LT((tracker.frame().robots[0].position - motion(t).robots[0].position).norm(), 0.005);
}

/// A ball that rolls and a robot that drives, true after whatever came before.
struct Simple {
  GroundBall ball{{-2, 1}, {0.5, 0}, false};
  Scene operator()(double t) const { return {ball.position(t), {{yellow_3, {-1 + 0.3 * t, -1}, 0.5}}}; }
};

void expect_right(const world::TrackedFrame& frame, const Simple& truth) {
  const double t = world::seconds(frame.time);
  ASSERT_TRUE(frame.ball);
  EXPECT_LT((frame.ball->position.head<2>() - truth.ball.position(t)).norm(), 0.005);
  EXPECT_LT((frame.ball->velocity.head<2>() - truth.ball.velocity(t)).norm(), 0.1);
  ASSERT_EQ(frame.robots.size(), 1u);
  EXPECT_LT((frame.robots[0].position - truth(t).robots[0].position).norm(), 0.005);
}

TEST(Tracker, StreamThatStopsGoesOnWithinThreeFrames) {
  const Simple truth;
  for (const std::int64_t gap : {20, 100, 400}) {  // ticks without any image
    Tracker tracker{world::Geometry{}};
    Cameras cameras;
    run(tracker, cameras, 1, 30, truth);
    EXPECT_EQ(tracker.update({}), nullptr);
    run(tracker, cameras, 30 + gap, 34 + gap, truth);
    expect_right(tracker.frame(), truth);
    EXPECT_EQ(tracker.restarts(), 0);
  }
}

TEST(Tracker, RepeatedImagesChangeNothing) {
  const Simple truth;
  Tracker plain{world::Geometry{}};
  Tracker repeated{world::Geometry{}};
  Cameras cameras;
  for (std::int64_t tick = 1; tick <= 60; ++tick) {
    auto images = cameras.images(tick, truth);
    plain.update(images);
    const std::size_t count = images.size();
    for (std::size_t n = 0; n < count; ++n) images.push_back(images[n]);
    repeated.update(images);
    EXPECT_EQ(repeated.update(images), nullptr);
    EXPECT_EQ(plain.frame().time, repeated.frame().time);
  }
  EXPECT_EQ(plain.frame().ball->velocity, repeated.frame().ball->velocity);
  EXPECT_EQ(plain.frame().robots[0].velocity, repeated.frame().robots[0].velocity);
  expect_right(repeated.frame(), truth);
}

TEST(Tracker, BatchesOutOfOrderCostFramesAndNothingElse) {
  const Simple truth;
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  world::Time last{world::Duration{-1}};
  for (std::int64_t tick = 1; tick <= 120; tick += 2) {  // pairs swapped
    const auto older = cameras.images(tick, truth);
    const auto newer = cameras.images(tick + 1, truth);
    for (const auto* images : {&newer, &older}) {
      if (const world::TrackedFrame* frame = tracker.update(*images)) {
        EXPECT_GT(frame->time, last);
        last = frame->time;
      }
    }
  }
  expect_right(tracker.frame(), truth);
  EXPECT_EQ(tracker.restarts(), 0);
}

TEST(Tracker, FiftyBallsInEveryImageDoNotLoseTheBall) {
  const Simple truth;
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 20, truth);
  world::RandomStream chaos(3, "fifty");
  for (std::int64_t tick = 21; tick <= 140; ++tick) {
    auto images = cameras.images(tick, truth);
    for (auto& image : images) {
      for (int n = 0; n < 50; ++n) {
        const Vector2d place(9 * chaos.uniform() - 4.5, 6 * chaos.uniform() - 3);
        image.balls.insert(image.balls.begin(), {.position = place});
      }
    }
    ASSERT_NE(tracker.update(images), nullptr);
    const world::TrackedFrame& frame = tracker.frame();
    ASSERT_TRUE(frame.ball);
    // One of 200 false balls within 2 cm of the true one is rare, and pulls by no more than that.
    EXPECT_LT((frame.ball->position.head<2>() - truth.ball.position(world::seconds(frame.time))).norm(),
              0.03);
  }
}

TEST(Tracker, UnknownIdsAndNothingNumbersAreNotRobots) {
  const Simple truth;
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const double nan = std::nan("");
  for (std::int64_t tick = 1; tick <= 60; ++tick) {
    auto images = cameras.images(tick, truth);
    for (auto& image : images) {
      image.robots.push_back({.team = Team::Blue, .number = 16, .position = {1, 1}, .orientation = 0.0});
      image.robots.push_back({.team = Team::Blue, .number = 255, .position = {1, 1}, .orientation = 0.0});
      image.robots.push_back(
          {.team = Team::Blue, .number = std::nullopt, .position = {1, 1}, .orientation = 0.0});
      image.robots.push_back(
          {.team = static_cast<Team>(7), .number = 1, .position = {1, 1}, .orientation = 0.0});
      image.robots.push_back({.team = Team::Blue, .number = 2, .position = {nan, 1}, .orientation = 0.0});
      image.balls.push_back({.position = {nan, nan}});
    }
    tracker.update(images);
  }
  expect_right(tracker.frame(), truth);
}

}  // namespace
}  // namespace tracker
