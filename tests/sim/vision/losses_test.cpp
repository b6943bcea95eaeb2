#include <gtest/gtest.h>

#include <cmath>

#include "sim/vision/bursts.h"
#include "tests/sim/vision/scene.h"

namespace {

using vision::Bursts;
using vision::Cameras;
using vision::Params;

// Which of `images` images of camera 0 have no ball.
std::vector<bool> lost_balls(const Params& params, int images, std::uint64_t seed = 1) {
  Cameras cameras(scene::geometry(), params, seed);
  std::vector<bool> lost;
  for (int i = 0; i < images; ++i) {
    lost.push_back(scene::tick(cameras, i, scene::ball_at(-2, -1))[0].balls.empty());
  }
  return lost;
}

struct Runs {
  int bursts = 0, lost = 0, seen = 0;
  double squares = 0;  // of the lengths
};

Runs runs(const std::vector<bool>& lost) {
  Runs result;
  int length = 0;
  for (const bool one : lost) {
    ++(one ? result.lost : result.seen);
    if (one) {
      ++length;
    } else if (length > 0) {
      ++result.bursts;
      result.squares += static_cast<double>(length) * length;
      length = 0;
    }
  }
  return result;
}

TEST(Bursts, HaveTheirRateAndTheirGeometricLengths) {
  for (const double length : {5.0, 15.0, 60.0}) {
    const double start = 0.01;
    const Runs found = runs(lost_balls({.ball_burst_start = start, .ball_burst_length = length}, 60'000));
    const double n = found.bursts, mean = found.lost / n;
    // A geometric length of mean L has the variance L (L - 1) and the mean square L (2 L - 1). Both the mean
    // and the mean square are right within 4 standard errors; the variance of the mean square is below
    // 20 L^4, that of an exponential law's square.
    EXPECT_NEAR(mean, length, 4 * std::sqrt(length * (length - 1) / n));
    EXPECT_NEAR(found.squares / n, length * (2 * length - 1), 4 * length * length * std::sqrt(20 / n));
    // Each seen image is followed by a burst with probability `start`: binomial.
    EXPECT_NEAR(n, start * found.seen, 4 * std::sqrt(start * found.seen));
  }
}

TEST(Bursts, AreStationaryFromTheFirstImage) {
  const double start = 0.05, length = 10, share = start * length / (1 + start * length);
  const int games = 3000;
  int first = 0, later = 0;
  for (int game = 0; game < games; ++game) {
    Bursts bursts(vision::Draws(static_cast<std::uint64_t>(game), "bursts"));
    for (std::uint32_t image = 0; image < 40; ++image) {
      const bool lost = bursts.lost(start, length, image, 5);
      if (image == 0) first += lost;
      if (image == 39) later += lost;
    }
  }
  const double tolerance = 4 * std::sqrt(games * share * (1 - share));  // binomial
  EXPECT_NEAR(first, share * games, tolerance);
  EXPECT_NEAR(later, share * games, tolerance);
}

TEST(Bursts, AreOfEachRobotAndEachCameraAlone) {
  Cameras cameras(scene::geometry(),
                  Params{.overlap = 1, .robot_burst_start = 0.05, .robot_burst_length = 10}, 1);
  const std::vector robots = {scene::robot_at(0, 0, 0, 3, world::Team::Yellow), scene::robot_at(0, 0, 0, 3),
                              scene::robot_at(0, 0, 0, 15)};
  // Two independent chains with share s are both lost in s^2 of the images; with a correlation time of
  // 1 / (start + 1 / length) = 6.7 images, N images count as N / 13.
  const double s = 0.5 / 1.5;
  const int count = 20'000;
  int together[2] = {0, 0};
  for (int i = 0; i < count; ++i) {
    const auto frames = scene::tick(cameras, i, scene::ball_at(3, 2), robots);
    const auto sees = [&](std::size_t camera, world::Team team, int number) {
      return std::any_of(frames[camera].robots.begin(), frames[camera].robots.end(),
                         [&](const auto& robot) { return robot.team == team && robot.number == number; });
    };
    const bool yellow = sees(0, world::Team::Yellow, 3), blue = sees(0, world::Team::Blue, 3);
    const bool elsewhere = sees(1, world::Team::Blue, 3);
    together[0] += !yellow && !blue;
    together[1] += !blue && !elsewhere;
  }
  for (const int both : together) {
    EXPECT_NEAR(static_cast<double>(both) / count, s * s, 4 * std::sqrt(s * s * (1 - s * s) * 13 / count));
  }
}

// A region of 20 m covers the camera's area whole, wherever its centre lies.
TEST(Regions, MakeTheBallFlicker) {
  const int count = 8000;
  const Runs found = runs(lost_balls({.regions = 1, .region_radius = 20, .region_missing = 0.3}, count));
  EXPECT_NEAR(found.lost, 0.3 * count, 4 * std::sqrt(count * 0.3 * 0.7));  // binomial
  // Without memory: a burst begins at each seen image with 0.3.
  EXPECT_NEAR(found.bursts, 0.3 * 0.7 * count, 4 * std::sqrt(count * 0.21));
}

TEST(Regions, LeaveTheBallAloneOutside) {
  const Params params{.regions = 1, .region_radius = 0.5, .region_missing = 1};
  // How much of the area of 5.45 x 3.95 m (0.25 m of overlap) in a game is lost: the disc's 0.785 m^2, less
  // what lies outside. Over many games and points: between 70 % and all of it.
  int lost = 0, all = 0;
  for (std::uint64_t game = 0; game < 300; ++game) {
    Cameras cameras(scene::geometry(), params, game);
    for (double x = -5; x < 0.2; x += 0.5) {
      for (double y = -3.5; y < 0.2; y += 0.5) {
        lost += scene::tick(cameras, 0, scene::ball_at(x, y))[0].balls.empty();
        ++all;
      }
    }
  }
  const double expected = 0.785 / (5.45 * 3.95);
  EXPECT_LT(static_cast<double>(lost) / all, 1.1 * expected);
  EXPECT_GT(static_cast<double>(lost) / all, 0.7 * expected);
}

}  // namespace
