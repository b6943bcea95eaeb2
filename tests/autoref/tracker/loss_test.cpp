#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <span>

#include "tests/autoref/tracker/running.h"

namespace tracker {
namespace {

TEST(Tracker, TeleportedBallIsFoundWithinThreeFrames) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 60, standing(Vector2d(1, 1)));
  const Vector2d spot(-3, 2);
  run(tracker, cameras, 61, 63, standing(spot));
  ASSERT_TRUE(tracker.frame().ball);
  EXPECT_LT((tracker.frame().ball->position.head<2>() - spot).norm(), 0.002);
  EXPECT_LT(tracker.frame().ball->velocity.norm(), 0.15);  // two sightings: 0.04 m/s per axis, 3.5 sigma
}

TEST(Tracker, FalseBallsDoNotMoveTheBall) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  world::RandomStream clutter(5, "clutter");
  const GroundBall ball{{-2, 1.5}, {1.5, 0}, false};
  for (std::int64_t tick = 1; tick <= 120; ++tick) {
    auto images = cameras.images(tick, [&](double t) { return Scene{ball.position(t), {}}; });
    for (auto& image : images) {
      image.balls.insert(image.balls.begin(), {.position = {3, -2}});  // a spare ball beside the game
      for (int n = 0; n < 12 && tick > 10; ++n) {
        image.balls.insert(image.balls.begin(),
                           {.position = {9 * clutter.uniform() - 4.5, 6 * clutter.uniform() - 3}});
      }
    }
    const world::TrackedFrame* frame = tracker.update(images);
    ASSERT_NE(frame, nullptr);
    if (tick < 30 || !frame->ball) continue;
    // Which of two balls is the game's is settled in the first frames; from then on it does not change.
    const Vector2d now = frame->ball->position.head<2>();
    const bool on_spare = (now - Vector2d(3, -2)).norm() < 0.05;
    const bool on_ball = (now - ball.position(world::seconds(frame->time))).norm() < 0.05;
    EXPECT_TRUE(on_spare || on_ball) << "tick " << tick << " at " << now.transpose();
  }
}

TEST(Tracker, SpareBallWaitsWhileTheBallIsHidden) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const auto tick_with = [&](std::int64_t tick, bool ball, bool spare) {
    auto images = cameras.images(tick, standing(ball ? std::optional(Vector2d(1, 1)) : std::nullopt));
    if (spare) images[0].balls.push_back({.position = {-2, -2}});
    tracker.update(images);
  };
  for (std::int64_t tick = 1; tick <= 60; ++tick) tick_with(tick, true, tick > 20);
  EXPECT_LT((tracker.frame().ball->position.head<2>() - Vector2d(1, 1)).norm(), 0.002);
  for (std::int64_t tick = 61; tick <= 90; ++tick) tick_with(tick, false, true);  // hidden for half a second
  EXPECT_LT((tracker.frame().ball->position.head<2>() - Vector2d(1, 1)).norm(), 0.01);
  EXPECT_FALSE(tracker.frame().ball->observed);
  for (std::int64_t tick = 91; tick <= 125; ++tick) tick_with(tick, false, true);  // over a second: believed
  EXPECT_LT((tracker.frame().ball->position.head<2>() - Vector2d(-2, -2)).norm(), 0.002);
}

TEST(Tracker, UnseenBallRollsOnWithFrictionAndIsForgotten) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const GroundBall ball{{-1, 1}, {1, 0}, false};
  run(tracker, cameras, 1, 60, [&](double t) { return Scene{ball.position(t), {}}; });
  world::Duration last{};
  run(tracker, cameras, 61, 120, standing(std::nullopt), [&](std::int64_t, const world::TrackedFrame& frame) {
    ASSERT_TRUE(frame.ball);
    EXPECT_FALSE(frame.ball->observed);
    EXPECT_GT(frame.ball->unseen, last);
    last = frame.ball->unseen;
  });
  const double t = world::seconds(tracker.frame().time);
  // One second on: 5 mm/s of velocity error (measured rms) makes 5 mm; four sigma.
  EXPECT_LT((tracker.frame().ball->position.head<2>() - ball.position(t)).norm(), 0.02);
  run(tracker, cameras, 121, 260, standing(std::nullopt));
  EXPECT_FALSE(tracker.frame().ball);
}

TEST(Tracker, HiddenBallStaysAtTheDribblerThatHadIt) {
  // The robot takes the ball along a circle while no camera sees it for 0.7 s.
  const auto robot_at = [](double t) {
    const double angle = 0.8 * t;
    const Vector2d p = Vector2d(0, 1) + 0.8 * world::direction(angle);
    return Scene::Robot{yellow_3, p, world::wrap_angle(angle + std::numbers::pi / 2)};
  };
  const auto ball_at = [&](double t) {
    const Scene::Robot robot = robot_at(t);
    return Vector2d(robot.position + 0.0945 * world::direction(robot.heading));
  };
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 60, [&](double t) { return Scene{ball_at(t), {robot_at(t)}}; });
  EXPECT_TRUE(tracker.frame().robots.at(0).ball_in_reach);
  run(
      tracker, cameras, 61, 100,
      [&](double t) {
        return Scene{std::nullopt, {robot_at(t)}};
      },
      [&](std::int64_t, const world::TrackedFrame& frame) {
        EXPECT_LT((frame.ball->position.head<2>() - ball_at(world::seconds(frame.time))).norm(), 0.01);
        EXPECT_TRUE(frame.robots.at(0).ball_in_reach);
        EXPECT_FALSE(frame.ball->observed);
      });
  run(tracker, cameras, 101, 101, [&](double t) { return Scene{ball_at(t), {robot_at(t)}}; });
  EXPECT_TRUE(tracker.frame().ball->observed);  // found at once where it was held
}

TEST(Tracker, BallInReachIsTheDribblerZone) {
  for (const double heading : {0.0, 2.1, -3.0}) {
    const world::TrackedRobot robot{.id = yellow_3, .position = {1, -1}, .orientation = heading};
    const auto in_zone = [&](double x, double y) {
      return in_dribbler_zone(robot, robot.position + world::rotated({x, y}, heading));
    };
    EXPECT_TRUE(in_zone(0.0945, 0));  // held
    EXPECT_TRUE(in_zone(0.08, 0.045));
    EXPECT_FALSE(in_zone(0.12, 0));  // free before the robot
    EXPECT_FALSE(in_zone(0.09, 0.055));
    EXPECT_FALSE(in_zone(-0.0945, 0));  // behind it
    EXPECT_FALSE(in_zone(0.02, 0.1));
  }
}

TEST(Tracker, RobotAppearsAfterThreeSightingsAndVanishesAfterHalfASecond) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const Motion there = standing(std::nullopt, {{yellow_3, {2, 1}, 1}});
  run(tracker, cameras, 1, 2, there);
  EXPECT_TRUE(tracker.frame().robots.empty());
  run(tracker, cameras, 3, 3, there);
  ASSERT_EQ(tracker.frame().robots.size(), 1u);
  run(tracker, cameras, 4, 30, there);
  run(tracker, cameras, 31, 59, standing(std::nullopt));
  ASSERT_EQ(tracker.frame().robots.size(), 1u);  // 29 ticks unseen
  EXPECT_FALSE(tracker.frame().robots[0].observed);
  run(tracker, cameras, 60, 61, standing(std::nullopt));
  EXPECT_TRUE(tracker.frame().robots.empty());
}

TEST(Tracker, TeleportedRobotIsFoundWithinThreeFrames) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 30, standing(std::nullopt, {{yellow_3, {2, 1}, 1}}));
  run(tracker, cameras, 31, 33, standing(std::nullopt, {{yellow_3, {-2, 1}, -2}}));
  const world::TrackedRobot& robot = tracker.frame().robots.at(0);
  EXPECT_LT((robot.position - Vector2d(-2, 1)).norm(), 0.002);
  EXPECT_NEAR(robot.orientation, -2, 0.015);
  EXPECT_LT(robot.velocity.norm(), 0.2);
}

TEST(Tracker, RobotStoppedByACollisionDoesNotDriftOn) {
  const Motion motion = [](double t) {
    const double x = t < 0.5 ? -1 + 2.5 * t : 0.25;  // 2.5 m/s, then a wall
    return Scene{std::nullopt, {{yellow_3, {x, 1}, 0}}};
  };
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 33, motion);
  EXPECT_LT(tracker.frame().robots.at(0).velocity.norm(), 0.2);  // two sightings later: 0.05 m/s per axis
  EXPECT_NEAR(tracker.frame().robots[0].position.x(), 0.25, 0.003);
}

TEST(Tracker, OneOfTwoRobotsWithTheSameIdIsFollowed) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 30, standing(std::nullopt, {{yellow_3, {2, 1}, 1}}));
  for (const bool false_first : {true, false}) {
    std::vector<Scene::Robot> robots{{yellow_3, {2, 1}, 1}};
    robots.insert(false_first ? robots.begin() : robots.end(), {yellow_3, {2.5, 1.2}, -2});
    const std::int64_t first = false_first ? 31 : 61;
    run(tracker, cameras, first, first + 29, standing(std::nullopt, robots),
        [](std::int64_t, const world::TrackedFrame& frame) {
          EXPECT_LT((frame.robots.at(0).position - Vector2d(2, 1)).norm(), 0.003);
          EXPECT_LT(frame.robots[0].velocity.norm(), 0.2);
        });
  }
}

TEST(Tracker, MisreadHeadingIsIgnoredUntilItPersists) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  run(tracker, cameras, 1, 30, standing(std::nullopt, {{yellow_3, {2, 1}, 0.5}}));
  run(tracker, cameras, 31, 31, standing(std::nullopt, {{yellow_3, {2, 1}, -2.6}}));
  EXPECT_NEAR(tracker.frame().robots.at(0).orientation, 0.5, 0.02);
  run(tracker, cameras, 32, 36, standing(std::nullopt, {{yellow_3, {2, 1}, -2.6}}));
  EXPECT_NEAR(tracker.frame().robots.at(0).orientation, -2.6, 0.02);
}

/// Four cameras as in a game, so that the tracker knows who hides what.
world::Geometry with_cameras() {
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  return geometry;
}

TEST(Tracker, BallHiddenBehindARobotStaysThereAndGoesAlongWithIt) {
  // The camera at (-2.25, -1.5) sees a robot at (-1, -1); the ball lies behind it and is not reported. After
  // a second the robot drives on along y; the ball's place would come into view, so the robot has the ball.
  const Vector2d away = Vector2d(1.25, 0.5).normalized();
  const Vector2d robot(-1, -1);
  const Vector2d ball = robot + 0.115 * away;
  Tracker tracker{with_cameras()};
  Cameras cameras;
  run(tracker, cameras, 1, 30, standing(ball, {{yellow_3, robot + Vector2d(0, 1), 3}}));
  run(tracker, cameras, 31, 90, standing(std::nullopt, {{yellow_3, robot, 3}}));
  ASSERT_TRUE(tracker.frame().ball);
  EXPECT_LT((tracker.frame().ball->position.head<2>() - ball).norm(), 0.002);
  EXPECT_GE(tracker.frame().ball->sigma, 0.010);
  const auto driving = [&](double t) { return Vector2d(robot + Vector2d(0, 0.8 * (t - 1.5))); };
  run(tracker, cameras, 91, 120, [&](double t) { return Scene{std::nullopt, {{yellow_3, driving(t), 3}}}; });
  const double t = world::seconds(tracker.frame().time);
  const Vector2d from_robot = tracker.frame().ball->position.head<2>() - driving(t);
  EXPECT_LT(from_robot.norm(), 0.14);  // hull and ball are 0.1115; it was hidden up to 25 mm beside that
  EXPECT_NEAR(tracker.frame().ball->velocity.y(), 0.8, 0.1);
}

TEST(Tracker, UnseenBallDoesNotRollThroughARobot) {
  Tracker tracker{with_cameras()};
  Cameras cameras;
  const GroundBall ball{{-3, 1.5}, {1.5, 0}, false};
  const std::vector<Scene::Robot> robots = {{yellow_3, {-1.5, 1.5}, 0}};
  run(tracker, cameras, 1, 40, [&](double t) { return Scene{ball.position(t), robots}; });
  run(tracker, cameras, 41, 90, [&](double) { return Scene{std::nullopt, robots}; });
  ASSERT_TRUE(tracker.frame().ball);
  // It would be at -0.9 m; it is at the hull's near side, 0.1115 m from the robot's centre.
  EXPECT_NEAR(tracker.frame().ball->position.x(), -1.5 - 0.1115, 0.01);
}

TEST(Tracker, SigmaGrowsWhileTheBallIsUnseen) {
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  const GroundBall ball{{-1, 1}, {1, 0}, false};
  run(tracker, cameras, 1, 60, [&](double t) { return Scene{ball.position(t), {}}; });
  EXPECT_GT(tracker.frame().ball->sigma, 0.0001);
  EXPECT_LT(tracker.frame().ball->sigma, 0.001);  // better than two sightings of 0.5 mm
  double last = 0;
  run(tracker, cameras, 61, 100, standing(std::nullopt), [&](std::int64_t, const world::TrackedFrame& frame) {
    EXPECT_GT(frame.ball->sigma, last);
    last = frame.ball->sigma;
  });
}

TEST(Tracker, CommandsHelpWhileARobotChangesItsSpeed) {
  // 0 to 2 m/s at 3 m/s^2, then brakes by 6 m/s^2; the command jumps, the robot follows.
  const auto speed = [](double t) {
    return t < 1 ? std::clamp(3 * (t - 0.3), 0.0, 2.0) : std::max(0.0, 2 - 6 * (t - 1));
  };
  const auto place = [](double t) {
    const double up = std::clamp(t - 0.3, 0.0, 2.0 / 3);
    const double on = std::clamp(t - 0.3 - 2.0 / 3, 0.0, 0.7 - 2.0 / 3);
    const double down = std::clamp(t - 1.0, 0.0, 1.0 / 3);
    return -1 + 1.5 * up * up + 2 * on + 2 * down - 3 * down * down;
  };
  const auto worst = [&](bool told) {
    Tracker tracker{world::Geometry{}};
    Cameras cameras;
    double sum = 0;
    for (std::int64_t tick = 1; tick <= 80; ++tick) {
      const auto images = cameras.images(tick, [&](double t) {
        return Scene{std::nullopt, {{yellow_3, {place(t), 1}, 0}}};
      });
      const double t = world::seconds(world::tick_time(tick));
      const CommandedVelocity command{yellow_3, {t > 0.3 && t < 1 ? 2.0 : 0.0, 0}};
      const auto* frame =
          tracker.update(images, told ? std::span(&command, 1) : std::span<const CommandedVelocity>());
      if (tick > 10) sum += (frame->robots.at(0).velocity - Vector2d(speed(t), 0)).squaredNorm();
    }
    return std::sqrt(sum / 70);
  };
  const double alone = worst(false), told = worst(true);
  std::cout << "robot speeding up and braking: velocity rms " << alone << " m/s, with commands " << told
            << "\n";
  EXPECT_LT(told, 0.8 * alone);
  EXPECT_LT(alone, 0.12);  // not needed
}

}  // namespace
}  // namespace tracker
