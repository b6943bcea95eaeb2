#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sim/vision/regions.h"
#include "tests/sim/vision/scene.h"

namespace {

using vision::Area;
using vision::Cameras;
using vision::Params;
using vision::Regions;
using world::Vector2d;

TEST(Bias, IsConstantInAGameAndTheSameForAllThatACameraSees) {
  Cameras cameras(scene::geometry(), Params{.bias_sigma = 0.01}, 9);
  const Vector2d ball(-2, -1), robot(-3, -2);
  std::array<Vector2d, 2> first;
  for (int i = 0; i < 100; ++i) {
    const auto frames = scene::tick(cameras, i, scene::ball_at(ball.x(), ball.y()),
                                    {scene::robot_at(robot.x(), robot.y(), 1)});
    const std::array now = {Vector2d(frames[0].balls.at(0).position),
                            Vector2d(frames[0].robots.at(0).position)};
    if (i == 0) first = now;
    EXPECT_EQ(now, first);
    EXPECT_EQ(frames[0].robots[0].orientation, 1.0);
  }
  EXPECT_NE(first[0], ball);
  EXPECT_LT(((first[0] - ball) - (first[1] - robot)).norm(), 1e-6);  // float millimetres
}

TEST(Bias, HasItsStandardDeviationOverGamesAndCameras) {
  const double sigma = 0.01;
  const int games = 1000;
  Vector2d sum = Vector2d::Zero();
  double squares = 0, product_of_axes = 0, product_of_cameras = 0;
  for (int game = 0; game < games; ++game) {
    Cameras cameras(scene::geometry(), Params{.bias_sigma = sigma}, static_cast<std::uint64_t>(game));
    const auto frames = scene::tick(cameras, 0, scene::ball_at(0, 0));
    const Vector2d a = frames[0].balls.at(0).position, b = frames[3].balls.at(0).position;
    sum += a + b;
    squares += a.squaredNorm() + b.squaredNorm();
    product_of_axes += a.x() * a.y();
    product_of_cameras += a.x() * b.x();
  }
  // Sums of Gaussians, chi-square with 4 degrees per game, products of two independent Gaussians (variance
  // sigma^4): each within 4 standard deviations.
  EXPECT_NEAR(sum.x(), 0, 4 * sigma * std::sqrt(2 * games));
  EXPECT_NEAR(sum.y(), 0, 4 * sigma * std::sqrt(2 * games));
  EXPECT_NEAR(squares / (sigma * sigma), 4 * games, 4 * std::sqrt(2 * 4 * games));
  EXPECT_NEAR(product_of_axes / (sigma * sigma), 0, 4 * std::sqrt(games));
  EXPECT_NEAR(product_of_cameras / (sigma * sigma), 0, 4 * std::sqrt(games));
}

TEST(Regions, ErrFromTheirOffsetInTheMiddleToNothingAtTheRim) {
  const Params params{.regions = 1, .region_radius = 0.5, .region_offset = 0.02};
  const Vector2d center(1, 2);
  const Area spot{center.x(), center.x(), center.y(), center.y()};  // the disc's centre can only be there
  const Regions regions(params, spot, {3, "regions"});
  const Vector2d error = regions.offset(center);
  EXPECT_NEAR(error.norm(), 0.02, 1e-15);
  for (double angle = 0; angle < 6; angle += 0.5) {
    for (const double distance : {0.1, 0.25, 0.4, 0.499}) {
      const Vector2d point = center + distance * world::direction(angle);
      EXPECT_LT((regions.offset(point) - (1 - distance / 0.5) * error).norm(), 1e-15);  // rounding
      EXPECT_TRUE(regions.contains(point));
    }
    const Vector2d outside = center + 0.501 * world::direction(angle);
    EXPECT_EQ(regions.offset(outside), Vector2d(0, 0));
    EXPECT_FALSE(regions.contains(outside));
  }
}

TEST(Regions, HaveDirectionsOfTheirOwnAndFillTheArea) {
  const Area area{-1, 3, 0, 2};
  const Params params{.regions = 1, .region_radius = 100, .region_offset = 1};
  Vector2d sum = Vector2d::Zero();
  const int games = 2000;
  for (int game = 0; game < games; ++game) {
    const Vector2d error =
        Regions(params, area, {static_cast<std::uint64_t>(game), "regions"}).offset({1, 1}).normalized();
    sum += error;
  }
  // A unit vector of any direction has the variance 1/2 per axis; 4 standard deviations.
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 4 * std::sqrt(games / 2.0));
}

TEST(Regions, KeepTheFirstWhenThereAreMore) {
  const Area area{-1, 3, 0, 2};
  Params params{.regions = 1, .region_radius = 0.3, .region_offset = 0.02};
  const Regions one(params, area, {3, "regions"});
  params.regions = 3;
  const Regions three(params, area, {3, "regions"});
  int in_one = 0, in_three = 0;
  for (double x = -1; x < 3; x += 0.1) {
    for (double y = 0; y < 2; y += 0.1) {
      EXPECT_TRUE(three.contains({x, y}) || !one.contains({x, y}));
      in_one += one.contains({x, y});
      in_three += three.contains({x, y});
    }
  }
  EXPECT_GT(in_three, in_one);
}

TEST(Regions, ShiftBallsAndRobotsAlike) {
  Cameras plain(scene::geometry(), Params{}, 4);
  Cameras shifted(scene::geometry(), Params{.regions = 1, .region_radius = 3, .region_offset = 0.02}, 4);
  const auto a = scene::tick(plain, 0, scene::ball_at(-2, -1), {scene::robot_at(-2, -1, 1)})[0];
  const auto b = scene::tick(shifted, 0, scene::ball_at(-2, -1), {scene::robot_at(-2, -1, 1)})[0];
  const Vector2d ball = b.balls.at(0).position - a.balls.at(0).position;
  EXPECT_GT(ball.norm(), 1e-4);
  EXPECT_LE(ball.norm(), 0.02 + 1e-6);
  EXPECT_LT((b.robots.at(0).position - a.robots.at(0).position - ball).norm(), 1e-6);  // float millimetres
  EXPECT_EQ(a.balls[0].pixel, b.balls[0].pixel);
}

TEST(RobotIds, AreMisreadAsAnyOther) {
  const double probability = 0.3;
  Cameras cameras(scene::geometry(), Params{.misread_id = probability}, 1);
  std::array<int, 16> seen{};
  const int count = 20'000;
  for (int i = 0; i < count; ++i) {
    const auto robot =
        scene::tick(cameras, i, scene::ball_at(3, 2), {scene::robot_at(-2, -1, 1, 5)})[0].robots.at(0);
    ++seen.at(*robot.number);
    EXPECT_EQ(robot.team, world::Team::Blue);
    EXPECT_EQ(robot.orientation, 1.0);
  }
  EXPECT_NEAR(seen[5], (1 - probability) * count, 4 * std::sqrt(count * 0.3 * 0.7));  // binomial
  double chi = 0;
  const double expected = (count - seen[5]) / 15.0;
  for (std::size_t number = 0; number < 16; ++number) {
    if (number != 5) chi += std::pow(seen.at(number) - expected, 2) / expected;
  }
  EXPECT_NEAR(chi, 14, 4 * std::sqrt(28));  // 14 degrees of freedom
}

TEST(RobotIds, AreUnreadTogetherWithTheOrientation) {
  Cameras cameras(scene::geometry(), Params{.misread_id = 0.5, .unread_id = 0.2}, 1);
  const int count = 10'000;
  int unread = 0, misread = 0;
  for (int i = 0; i < count; ++i) {
    const auto robot =
        scene::tick(cameras, i, scene::ball_at(3, 2), {scene::robot_at(-2, -1, 1, 5)})[0].robots.at(0);
    EXPECT_EQ(robot.number.has_value(), robot.orientation.has_value());
    EXPECT_EQ(robot.position, Vector2d(-2, -1));
    unread += !robot.number;
    misread += robot.number && robot.number != 5;
  }
  // Binomial; a pattern that is not read cannot be misread.
  EXPECT_NEAR(unread, 0.2 * count, 4 * std::sqrt(count * 0.2 * 0.8));
  EXPECT_NEAR(misread, 0.4 * count, 4 * std::sqrt(count * 0.4 * 0.6));
}

}  // namespace
