#include "sim/vision/cameras.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/sim/vision/scene.h"

namespace {

using vision::Cameras;
using vision::Params;
using world::Vector2d;
using world::Vector3d;

using scene::ball_at;
using scene::geometry;
using scene::robot_at;
using scene::tick;

TEST(Cameras, EachCapturesAfterItsOwnSubstep) {
  Cameras cameras(geometry(), Params{}, 1);
  const auto frames = tick(cameras, 7, ball_at(0, 0));
  ASSERT_EQ(frames.size(), 4U);
  for (int c = 0; c < 4; ++c) {
    const world::Detection& frame = frames[static_cast<std::size_t>(c)];
    EXPECT_EQ(frame.camera, c);
    EXPECT_EQ(frame.t_capture, world::whole_microseconds(world::tick_time(7, c + 1)));
    EXPECT_EQ(frame.t_sent, frame.t_capture);
    EXPECT_EQ(frame.frame_number, 0U);
  }
  EXPECT_EQ(tick(cameras, 8, ball_at(0, 0))[2].frame_number, 1U);
}

TEST(Cameras, ManyCamerasShareThePhases) {
  world::Geometry six = geometry();
  six.cameras.push_back({4, {0, 0, 4}});
  six.cameras.push_back({9, {0.5, 0, 4}});
  Cameras cameras(six, Params{}, 1);
  const auto frames = tick(cameras, 0, ball_at(0, 0));
  ASSERT_EQ(frames.size(), 6U);
  EXPECT_EQ(frames[1].camera, 4);  // in the order of capture: 0 and 4 after the first substep
  EXPECT_EQ(frames[0].t_capture, frames[1].t_capture);
  for (std::size_t i = 1; i < frames.size(); ++i) EXPECT_LE(frames[i - 1].t_capture, frames[i].t_capture);
}

TEST(Cameras, SeeTheirQuarterAndTheOverlap) {
  Cameras cameras(geometry(), Params{.overlap = 0.25}, 1);
  const auto seen_by = [&](double x, double y) {
    std::vector<int> who;
    for (const auto& frame : tick(cameras, 0, ball_at(x, y))) {
      if (!frame.balls.empty()) who.push_back(frame.camera);
    }
    return who;
  };
  EXPECT_EQ(seen_by(-2, -1), (std::vector<int>{0}));
  EXPECT_EQ(seen_by(5.1, 3.6), (std::vector<int>{3}));  // everything inside the walls is seen
  EXPECT_EQ(seen_by(0.24, -1), (std::vector<int>{0, 2}));
  EXPECT_EQ(seen_by(0.26, -1), (std::vector<int>{2}));
  EXPECT_EQ(seen_by(0, 0), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Cameras, PerfectOnesGiveTheTruthAsItIsOnTheWire) {
  Cameras cameras(geometry(), Params{}, 1);
  const auto frames = tick(cameras, 0, ball_at(-1.23456789, -2), {robot_at(-3.000001, -1, 2.5)});
  ASSERT_EQ(frames[0].balls.size(), 1U);
  EXPECT_EQ(frames[0].balls[0].position.x(), world::as_on_wire(-1.23456789));
  ASSERT_EQ(frames[0].robots.size(), 1U);
  EXPECT_EQ(frames[0].robots[0].position.x(), world::as_on_wire(-3.000001));
  EXPECT_EQ(frames[0].robots[0].orientation, static_cast<double>(2.5F));
  EXPECT_EQ(frames[0].robots[0].number, 3);
  EXPECT_EQ(frames[0].robots[0].team, world::Team::Blue);
}

TEST(Cameras, NoisyNumbersAreStillWireNumbers) {
  Cameras cameras(geometry(), Params{.ball_sigma = 0.001, .robot_sigma = 0.001, .orientation_sigma = 0.01},
                  1);
  for (int i = 0; i < 50; ++i) {
    const auto frames = tick(cameras, i, ball_at(-1, -2), {robot_at(-3, -1, M_PI)});
    const Vector2d ball = frames[0].balls.at(0).position;
    EXPECT_EQ(ball, world::as_on_wire(ball));
    const double orientation = *frames[0].robots.at(0).orientation;
    EXPECT_EQ(orientation, static_cast<double>(static_cast<float>(orientation)));
    EXPECT_LE(std::abs(orientation), M_PI + 1e-6);  // a float next to pi
  }
}

TEST(Cameras, NoiseHasItsStandardDeviation) {
  const Params params{.ball_sigma = 0.0005, .robot_sigma = 0.00055, .orientation_sigma = 0.0035};
  Cameras cameras(geometry(), params, 42);
  const int count = 4000;
  double ball = 0, robot = 0, turn = 0, mean = 0;
  for (int i = 0; i < count; ++i) {
    const auto frames = tick(cameras, i, ball_at(-1, -2), {robot_at(-3, -1, 0.5)});
    const Vector2d b = frames[0].balls.at(0).position - Vector2d(-1, -2);
    const Vector2d r = frames[0].robots.at(0).position - Vector2d(-3, -1);
    ball += b.squaredNorm();
    mean += b.x();
    robot += r.squaredNorm();
    turn += std::pow(*frames[0].robots[0].orientation - 0.5, 2);
  }
  // The sum of n squares over sigma^2 is chi-square with n degrees of freedom: standard deviation sqrt(2 n).
  // Within 4 of these (false alarm below 1e-4; the seed is fixed).
  const auto expect_chi_square = [](double sum, double sigma, double n) {
    EXPECT_NEAR(sum / (sigma * sigma), n, 4 * std::sqrt(2 * n));
  };
  expect_chi_square(ball, params.ball_sigma, 2 * count);
  expect_chi_square(robot, params.robot_sigma, 2 * count);
  expect_chi_square(turn, params.orientation_sigma, count);
  EXPECT_NEAR(mean / count, 0, 4 * params.ball_sigma / std::sqrt(count));
}

TEST(Cameras, LoseTheirShare) {
  Cameras cameras(geometry(), Params{.ball_missing = 0.05, .robot_missing = 0.02}, 42);
  const int count = 4000;
  int balls = 0, robots = 0;
  for (int i = 0; i < count; ++i) {
    const auto frames = tick(cameras, i, ball_at(-1, -2), {robot_at(-3, -1, 0.5)});
    balls += static_cast<int>(frames[0].balls.size());
    robots += static_cast<int>(frames[0].robots.size());
  }
  // Binomial, 4 standard deviations.
  EXPECT_NEAR(balls, 0.95 * count, 4 * std::sqrt(count * 0.05 * 0.95));
  EXPECT_NEAR(robots, 0.98 * count, 4 * std::sqrt(count * 0.02 * 0.98));
}

TEST(Cameras, WhatOneLosesDoesNotShiftTheNoiseOfAnything) {
  Cameras all(geometry(), Params{.ball_sigma = 0.001, .robot_sigma = 0.001}, 5);
  Cameras lossy(geometry(), Params{.ball_sigma = 0.001, .robot_sigma = 0.001, .ball_missing = 0.5}, 5);
  int lost = 0;
  for (int i = 0; i < 100; ++i) {
    const auto a = tick(all, i, ball_at(0, 0), {robot_at(0.1, 0.1, 0)});
    const auto b = tick(lossy, i, ball_at(0, 0), {robot_at(0.1, 0.1, 0)});
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(a[c].robots.at(0).position, b[c].robots.at(0).position);
      if (b[c].balls.empty()) {
        ++lost;
      } else {
        EXPECT_EQ(a[c].balls.at(0).position, b[c].balls[0].position);
      }
    }
  }
  EXPECT_GT(lost, 100);
}

TEST(Cameras, SeedsAndCamerasHaveNoiseOfTheirOwn) {
  Cameras one(geometry(), Params{.ball_sigma = 0.001}, 5), same(geometry(), Params{.ball_sigma = 0.001}, 5);
  Cameras other(geometry(), Params{.ball_sigma = 0.001}, 6);
  const auto a = tick(one, 0, ball_at(0, 0)), b = tick(same, 0, ball_at(0, 0)),
             c = tick(other, 0, ball_at(0, 0));
  EXPECT_EQ(a[0].balls[0].position, b[0].balls[0].position);
  EXPECT_NE(a[0].balls[0].position, c[0].balls[0].position);
  EXPECT_NE(a[0].balls[0].position, a[1].balls[0].position);
}

TEST(Cameras, DeliverAfterTheirDelay) {
  for (const int delay : {0, 1, 3}) {
    Cameras cameras(geometry(), Params{.delay = delay}, 1);
    for (int i = 0; i < 8; ++i) {
      const auto frames = tick(cameras, i, ball_at(0, 0));
      ASSERT_EQ(frames.size(), i < delay ? 0U : 4U);
      if (frames.empty()) continue;
      EXPECT_EQ(frames[0].t_capture, world::whole_microseconds(world::tick_time(i - delay, 1)));
      EXPECT_EQ(frames[0].t_sent, world::whole_microseconds(world::tick_time(i, 1)));
      EXPECT_EQ(frames[0].frame_number, static_cast<std::uint32_t>(i - delay));
    }
  }
}

TEST(Projection, ARaisedBallAppearsWhereItsRayMeetsTheGround) {
  // Camera 4 m above (1, 1); ball 1 m up, 0.6 m beside: the ray meets the ground at 4/3 of that.
  const Vector2d seen = vision::projected_to_ground({1, 1, 4}, {1.6, 1, 1.0215}, 0.0215);
  EXPECT_NEAR(seen.x(), 1.8, 1e-12);
  EXPECT_NEAR(seen.y(), 1, 1e-12);
}

TEST(Projection, LiesOnTheLineThroughCameraAndBall) {
  const Vector3d camera(-2, 1, 4), ball(0.3, -0.7, 0.0215 + 0.8);
  const Vector2d seen = vision::projected_to_ground(camera, ball, 0.0215);
  // Counted from the height of a resting ball.
  const Vector3d eye = camera, on_ray(ball.x(), ball.y(), 0.8), end(seen.x(), seen.y(), 0);
  EXPECT_NEAR((on_ray - eye).cross(end - eye).norm(), 0, 1e-12);
}

TEST(Projection, StaysFiniteNearTheCamera) {
  EXPECT_TRUE(vision::projected_to_ground({0, 0, 2}, {1, 0, 2}, 0.0215).allFinite());
}

TEST(Projection, TheDetectionIsTheProjectedBall) {
  Cameras cameras(geometry(), Params{}, 1);
  const auto frames = tick(cameras, 0, ball_at(-1, -2, 1));
  const Vector2d expected =
      vision::projected_to_ground(geometry().cameras[0].position, {-1, -2, 1.0215}, 0.0215);
  EXPECT_EQ(frames[0].balls.at(0).position, world::as_on_wire(expected));
}

TEST(Cameras, RefuseNonsense) {
  world::Geometry none;
  EXPECT_THROW(Cameras(none, Params{}, 1), std::invalid_argument);
  world::Geometry low = geometry();
  low.cameras[1].position.z() = 0.1;
  EXPECT_THROW(Cameras(low, Params{}, 1), std::invalid_argument);
  world::Geometry twice = geometry();
  twice.cameras[1].id = 0;
  EXPECT_THROW(Cameras(twice, Params{}, 1), std::invalid_argument);
  world::Geometry blind = geometry();
  blind.cameras[2].focal_length = 0;
  EXPECT_THROW(Cameras(blind, Params{}, 1), std::invalid_argument);
  blind = geometry();
  blind.cameras[2].image_width = 0;
  EXPECT_THROW(Cameras(blind, Params{}, 1), std::invalid_argument);
  world::RobotSpecs body;
  body.center_to_dribbler = 0.1;  // outside the radius
  EXPECT_THROW(Cameras(geometry(), Params{}, 1, body), std::invalid_argument);
  body = {};
  body.height = 3;  // too near the cameras
  EXPECT_THROW(Cameras(geometry(), Params{}, 1, body), std::invalid_argument);

  const double nothing = std::nan("");
  for (const Params& params : {Params{.overlap = -0.1},
                               Params{.delay = -1},
                               Params{.delay = 61},
                               Params{.ball_sigma = nothing},
                               Params{.robot_sigma = -1},
                               Params{.orientation_sigma = INFINITY},
                               Params{.bias_sigma = -1},
                               Params{.area_sigma = nothing},
                               Params{.ball_missing = 1.5},
                               Params{.robot_missing = nothing},
                               Params{.visible_share = 1.1},
                               Params{.ball_burst_start = -0.1},
                               Params{.ball_burst_length = 0.5},
                               Params{.robot_burst_start = 2},
                               Params{.robot_burst_length = 0},
                               Params{.regions = -1},
                               Params{.region_radius = 0},
                               Params{.region_missing = 1.1},
                               Params{.region_offset = -0.1},
                               Params{.false_ball_rate = 61},
                               Params{.false_ball_shortest = 0},
                               Params{.false_ball_longest = 1001},
                               Params{.misread_id = -1},
                               Params{.unread_id = nothing},
                               Params{.false_ball_shortest = 9, .false_ball_longest = 8}}) {
    EXPECT_THROW(Cameras(geometry(), params, 1), std::invalid_argument);
  }
}

TEST(Cameras, SayWhatIsWrong) {
  try {
    Cameras(geometry(), Params{.false_ball_shortest = 9, .false_ball_longest = 8}, 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "vision: false_ball_shortest must be at most false_ball_longest, 8, is 9");
  }
}

}  // namespace
