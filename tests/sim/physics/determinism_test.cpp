#include <gtest/gtest.h>

#include <bit>
#include <thread>

#include "sim/physics/hull.h"
#include "tests/sim/physics/chase.h"

namespace {

// FNV-1a over the bits of all poses.
std::uint64_t hash_of_chase(std::uint64_t seed, int ticks) {
  Chase chase(seed);
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto add = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
  };
  for (int i = 0; i < ticks; ++i) {
    chase.tick();
    const truth::Ball& ball = chase.arena.ball();
    for (int k = 0; k < 3; ++k) add(ball.position[k]), add(ball.velocity[k]), add(ball.spin[k]);
    chase.arena.world.read_robots(chase.arena.robots);
    for (const truth::Robot& robot : chase.arena.robots) {
      add(robot.position.x()), add(robot.position.y()), add(robot.orientation);
    }
  }
  return hash;
}

TEST(Determinism, RepeatedWorldsAgreeToTheBit) {
  const std::uint64_t first = hash_of_chase(1, 600);
  EXPECT_EQ(first, hash_of_chase(1, 600));
  EXPECT_NE(first, hash_of_chase(2, 600));
}

TEST(Determinism, WorldsInTwoThreadsAgreeWithOneAlone) {
  const std::uint64_t alone = hash_of_chase(3, 600);
  std::uint64_t a = 0, b = 0;
  std::thread one([&] { a = hash_of_chase(3, 600); });
  std::thread two([&] { b = hash_of_chase(3, 600); });
  one.join();
  two.join();
  EXPECT_EQ(a, alone);
  EXPECT_EQ(b, alone);
}

TEST(Chase, BodiesStayApartAndInsideForTwoMinutes) {
  Chase chase(7);
  double worst_robots = 0, worst_ball = 0;
  for (int i = 0; i < 7200; ++i) {
    chase.tick();
    Arena& arena = chase.arena;
    arena.world.read_robots(arena.robots);
    const world::Vector2d ball = arena.ball().position.head<2>();
    ASSERT_TRUE(arena.ball().position.allFinite());
    ASSERT_LT(std::abs(ball.x()), 5.2) << i;
    ASSERT_LT(std::abs(ball.y()), 3.7) << i;
    if (arena.ball().position.z() < 0.1) {
      worst_ball = std::max(worst_ball, 0.0215 - arena.world.distance_to_robots(ball));
    }
    for (std::size_t a = 0; a < 12; ++a) {
      for (std::size_t b = a + 1; b < 12; ++b) {
        const double gap = (arena.robots[a].position - arena.robots[b].position).norm();
        worst_robots = std::max(worst_robots, 0.146 - gap);
      }
    }
  }
  std::printf("two minutes of chasing: ball in a robot %.1f mm, robots %.1f mm beyond front to front\n",
              worst_ball * 1000, worst_robots * 1000);
  EXPECT_LT(worst_ball, 0.035);    // one substep at 8 m/s is 33 mm
  EXPECT_LT(worst_robots, 0.025);  // one substep at 6 m/s closing
}

}  // namespace
