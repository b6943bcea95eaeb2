#include "sim/vision/false_balls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "tests/sim/vision/scene.h"

namespace {

using vision::Area;
using vision::Cameras;
using vision::FalseBalls;
using vision::Params;
using world::Vector2d;

constexpr double ball_radius = 0.0215;
const Area area{-4, 0, -3, 0};
const world::RobotSpecs body;

FalseBalls false_balls(const Params& params, std::uint64_t seed = 1) {
  return {params, area, ball_radius, body, vision::Draws(seed, "false balls")};
}

TEST(FalseBalls, ComeAtTheirRateAndLastAsLongAsTheyShould) {
  const Params params{.false_ball_rate = 6, .false_ball_shortest = 3, .false_ball_longest = 30};
  FalseBalls balls = false_balls(params);
  const std::uint32_t count = 60'000;
  std::map<std::uint32_t, int> lengths;  // by the image of the beginning
  for (std::uint32_t image = 0; image < count; ++image) {
    for (const auto& ball : balls.update(image, {})) ++lengths[image - ball.age];
  }
  const double n = static_cast<double>(lengths.size());
  EXPECT_NEAR(n, 0.1 * count, 4 * std::sqrt(count * 0.1 * 0.9));  // 6 a second, 60 images a second: binomial
  std::vector<int> histogram(31, 0);
  for (const auto& [begin, length] : lengths) {
    if (begin + 30 < count) ++histogram.at(static_cast<std::size_t>(length));
  }
  double chi = 0;
  for (std::size_t length = 0; length <= 30; ++length) {
    if (length < 3) {
      EXPECT_EQ(histogram[length], 0);
    } else {
      chi += std::pow(histogram[length] - n / 28, 2) / (n / 28);
    }
  }
  EXPECT_NEAR(chi, 27, 4 * std::sqrt(2 * 27));  // uniform over 28 lengths
}

TEST(FalseBalls, LieHalfOnRobotsAndMoveAndTurnWithThem) {
  FalseBalls balls = false_balls({.false_ball_rate = 30, .false_ball_shortest = 2, .false_ball_longest = 2});
  int on_robots = 0, elsewhere = 0;
  std::map<unsigned, int> on;
  for (std::uint32_t image = 0; image < 8000; image += 2) {
    // Two robots far outside the area, where nothing else lies.
    truth::Robot a = scene::robot_at(10, 0, 0, 1), b = scene::robot_at(20, 0, 0, 2);
    const std::array<const truth::Robot*, 2> robots = {&a, &b};
    std::map<std::uint32_t, FalseBalls::Seen> before;
    for (const auto& ball : balls.update(image, robots)) before.emplace(image - ball.age, ball);
    a.position = {10, 5};
    b.orientation = 1;
    for (const auto& ball : balls.update(image + 1, robots)) {
      const auto found = before.find(image + 1 - ball.age);
      if (found == before.end() || found->second.age > 0) continue;
      const Vector2d was = found->second.place.head<2>(), is = ball.place.head<2>();
      if (was.x() < 5) {
        ++elsewhere;
        EXPECT_TRUE(area.contains(was));
        EXPECT_EQ(was, is);
        EXPECT_EQ(ball.place.z(), ball_radius);
        continue;
      }
      ++on_robots;
      EXPECT_EQ(ball.place.z(), body.height);
      const bool on_a = was.x() < 15;
      ++on[on_a];
      EXPECT_LE((was - (on_a ? Vector2d(10, 0) : Vector2d(20, 0))).norm(), body.radius);
      const Vector2d expected = on_a ? Vector2d(was + Vector2d(0, 5))
                                     : Vector2d(Vector2d(20, 0) + world::rotated(was - Vector2d(20, 0), 1));
      EXPECT_LT((is - expected).norm(), 1e-12);
    }
  }
  const double n = on_robots + elsewhere;
  EXPECT_GT(n, 1500);
  EXPECT_NEAR(on_robots, n / 2, 2 * std::sqrt(n));  // binomial: 4 standard deviations of sqrt(n) / 2
  EXPECT_NEAR(on[0], on_robots / 2.0, 2 * std::sqrt(on_robots));
}

TEST(FalseBalls, StayOffTheFieldOfACameraWithTheirRobot) {
  FalseBalls balls = false_balls({.false_ball_rate = 60, .false_ball_shortest = 5, .false_ball_longest = 5});
  const truth::Robot robot = scene::robot_at(10, 0, 0, 1);
  const std::array<const truth::Robot*, 1> one = {&robot};
  int with = 0, without = 0;
  for (std::uint32_t image = 0; image < 100; ++image) {
    // In every other image the robot is not in view.
    const bool in_view = image % 2 == 0;
    const auto& seen = balls.update(
        image, in_view ? std::span<const truth::Robot* const>(one) : std::span<const truth::Robot* const>());
    for (const auto& ball : seen) (in_view ? with : without) += ball.place.x() > 5;
  }
  EXPECT_GT(with, 20);
  EXPECT_EQ(without, 0);
}

TEST(FalseBalls, AppearWhereTheRayThroughThemMeetsTheGround) {
  // Both kinds beside the true ball, which is out of view of camera 0.
  Cameras cameras(scene::geometry(),
                  Params{.false_ball_rate = 20, .false_ball_shortest = 3, .false_ball_longest = 30}, 5);
  const Vector2d spot(-4, -2.5);
  const world::Camera camera = scene::geometry().cameras[0];
  // A disc of 90 mm at 0.15 m, followed down: 0.1285 m over the resting ball's centre.
  const double scale = 4 / (4 - (0.15 - ball_radius));
  const Vector2d foot = camera.position.head<2>(), shadow = foot + (spot - foot) * scale;
  int on_robot = 0, elsewhere = 0;
  std::set<double> areas;
  for (int i = 0; i < 600; ++i) {
    const auto frames =
        scene::tick(cameras, i, scene::ball_at(3, 2), {scene::robot_at(spot.x(), spot.y(), 0)});
    for (const auto& ball : frames[0].balls) {
      (((ball.position - shadow).norm() <= 0.09 * scale + 1e-6) ? on_robot : elsewhere)++;
      areas.insert(ball.area);
      const double whole =
          vision::ball_area(camera, {ball.position.x(), ball.position.y(), ball_radius}, ball_radius);
      EXPECT_GE(ball.area + 0.5, 0.25 * whole);
      EXPECT_LE(ball.area - 0.5, 1.1 * whole);  // those on robots are nearer to the camera
      EXPECT_EQ(ball.position, world::as_on_wire(ball.position));
    }
  }
  EXPECT_GT(on_robot, 200);
  EXPECT_GT(elsewhere, 200);
  EXPECT_GT(areas.size(), 10U);
}

TEST(FalseBalls, ScatterAsTheBallDoes) {
  Params params{.false_ball_rate = 2, .false_ball_shortest = 3, .false_ball_longest = 30};
  Cameras exact(scene::geometry(), params, 5);
  params.ball_sigma = 0.0005;
  Cameras noisy(scene::geometry(), params, 5);
  double squares = 0;
  int count = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto a = scene::tick(exact, i, scene::ball_at(3, 2)),
               b = scene::tick(noisy, i, scene::ball_at(3, 2));
    if (a[0].balls.size() != 1) continue;  // which is which
    squares += (a[0].balls[0].position - b[0].balls.at(0).position).squaredNorm();
    ++count;
  }
  ASSERT_GT(count, 10);
  // Chi-square with two degrees of freedom for each.
  const double found = squares / (params.ball_sigma * params.ball_sigma);
  EXPECT_NEAR(found, 2 * count, 4 * std::sqrt(4 * count));
}

TEST(FalseBalls, AreListedByConfidenceAsOthersAre) {
  Cameras cameras(scene::geometry(),
                  Params{.false_ball_rate = 30, .false_ball_shortest = 3, .false_ball_longest = 30}, 5);
  int true_first = 0, true_later = 0;
  for (int i = 0; i < 500; ++i) {
    const auto balls = scene::tick(cameras, i, scene::ball_at(-2, -1))[0].balls;
    for (std::size_t k = 1; k < balls.size(); ++k) EXPECT_GE(balls[k - 1].confidence, balls[k].confidence);
    if (balls.size() > 1) ++(balls[0].position == Vector2d(-2, -1) ? true_first : true_later);
  }
  EXPECT_GT(true_later, 50);
  RecordProperty("true_first", true_first);
}

// The physical case: a real ball on top of a robot is projected from its height and not hidden by it.
TEST(FalseBalls, ARealBallOnARobotIsSeenFromItsHeight) {
  Cameras cameras(scene::geometry(), Params{.visible_share = 1}, 1);
  const auto frame =
      scene::tick(cameras, 0, scene::ball_at(-4, -2.5, 0.15), {scene::robot_at(-4, -2.5, 0)})[0];
  const Vector2d foot = scene::geometry().cameras[0].position.head<2>();
  const Vector2d expected = foot + (Vector2d(-4, -2.5) - foot) * (4 / (4 - 0.15));
  EXPECT_LT((frame.balls.at(0).position - expected).norm(), 1e-6);  // float millimetres
}

}  // namespace
