#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "tests/autoref/tracker/running.h"

namespace tracker {
namespace {

/// The images as seen from the other side of the table: turned by pi, or mirrored at the x axis.
std::vector<world::Detection> turned(std::vector<world::Detection> images, bool mirror) {
  const auto move = [&](Vector2d& p) { p = mirror ? Vector2d(p.x(), -p.y()) : Vector2d(-p); };
  for (auto& image : images) {
    for (auto& ball : image.balls) move(ball.position);
    for (auto& robot : image.robots) {
      move(robot.position);
      robot.orientation =
          mirror ? -*robot.orientation : world::wrap_angle(*robot.orientation + std::numbers::pi);
    }
  }
  return images;
}

TEST(Tracker, MirroredAndTurnedGamesAreTheSameGame) {
  for (const bool mirror : {true, false}) {
    Tracker plain{world::Geometry{}};
    Tracker other{world::Geometry{}};
    Cameras cameras;
    const Game game(3, 3);
    for (std::int64_t tick = 1; tick <= 150; ++tick) {
      const auto images = cameras.images(tick, std::cref(game));
      plain.update(images);
      other.update(turned(images, mirror));
      const world::TrackedFrame& a = plain.frame();
      const world::TrackedFrame& b = other.frame();
      ASSERT_EQ(a.robots.size(), b.robots.size());
      ASSERT_EQ(a.ball.has_value(), b.ball.has_value());
      const auto back = [&](const Vector2d& p) { return mirror ? Vector2d(p.x(), -p.y()) : Vector2d(-p); };
      // Rounding only: of positions up to 4 m times a gain of 60/s.
      if (a.ball) {
        EXPECT_LT((a.ball->position.head<2>() - back(b.ball->position.head<2>())).norm(), 1e-9);
        EXPECT_LT((a.ball->velocity.head<2>() - back(b.ball->velocity.head<2>())).norm(), 1e-9);
      }
      for (std::size_t n = 0; n < a.robots.size(); ++n) {
        EXPECT_LT((a.robots[n].position - back(b.robots[n].position)).norm(), 1e-9);
        EXPECT_LT((a.robots[n].velocity - back(b.robots[n].velocity)).norm(), 1e-9);
        EXPECT_EQ(a.robots[n].ball_in_reach, b.robots[n].ball_in_reach);
        const double heading = mirror ? -b.robots[n].orientation : b.robots[n].orientation + std::numbers::pi;
        EXPECT_NEAR(world::wrap_angle(a.robots[n].orientation - heading), 0, 1e-9);
      }
    }
  }
}

TEST(Tracker, ColoursDoNotMatter) {
  Tracker plain{world::Geometry{}};
  Tracker swapped{world::Geometry{}};
  Cameras cameras;
  const Game game(4, 3);
  for (std::int64_t tick = 1; tick <= 120; ++tick) {
    auto images = cameras.images(tick, std::cref(game));
    plain.update(images);
    for (auto& image : images) {
      for (auto& robot : image.robots) robot.team = world::opponent(robot.team);
    }
    swapped.update(images);
    for (const world::TrackedRobot& robot : plain.frame().robots) {
      const auto* twin =
          world::find_robot(swapped.frame(), {world::opponent(robot.id.team), robot.id.number});
      ASSERT_NE(twin, nullptr);
      EXPECT_EQ(robot.position, twin->position);
      EXPECT_EQ(robot.angular_velocity, twin->angular_velocity);
    }
    if (plain.frame().ball) {
      EXPECT_EQ(plain.frame().ball->velocity, swapped.frame().ball->velocity);
    }
  }
}

}  // namespace
}  // namespace tracker
