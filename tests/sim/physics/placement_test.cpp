#include "sim/physics/placement.h"

#include <gtest/gtest.h>

#include "sim/physics/hull.h"
#include "tests/sim/physics/arena.h"

namespace {

using world::Vector2d;

double kinetic_energy(Arena& arena) {
  double sum = 0.5 * 0.046 * arena.ball().velocity.squaredNorm();
  arena.world.read_robots(arena.robots);
  for (const truth::Robot& robot : arena.robots) sum += 0.5 * 2.5 * robot.velocity.squaredNorm();
  return sum;
}

// Clear of the spot, inside the walls, and no two overlapping.
void expect_orderly(Arena& arena, const Vector2d& spot, double clearance) {
  EXPECT_GT(arena.world.distance_to_robots(spot), clearance);
  arena.world.read_robots(arena.robots);
  for (std::size_t a = 0; a < arena.robots.size(); ++a) {
    const Vector2d& place = arena.robots[a].position;
    EXPECT_LT(std::abs(place.x()), 5.2 - 0.09);
    EXPECT_LT(std::abs(place.y()), 3.7 - 0.09);
    EXPECT_EQ(arena.robots[a].velocity.norm(), 0);
    for (const physics::Fixture& fixture : physics::fixtures(arena.field)) {
      if (fixture.min.z() > 0.15) continue;  // robots fit under a goal's roof
      EXPECT_GE(physics::plane_distance(fixture, place), 0.09);
    }
    for (std::size_t b = a + 1; b < arena.robots.size(); ++b) {
      EXPECT_GT((place - arena.robots[b].position).norm(), 0.18);
    }
  }
}

TEST(Hull, DistanceIsExactAtFrontCornerAndRound) {
  const world::RobotSpecs specs;
  EXPECT_NEAR(physics::hull_distance_local(specs, {0.173, 0}), 0.1, 1e-12);
  EXPECT_NEAR(physics::hull_distance_local(specs, {-0.19, 0}), 0.1, 1e-12);
  const double corner = std::sqrt(0.09 * 0.09 - 0.073 * 0.073);
  EXPECT_NEAR(physics::hull_distance_local(specs, {0.073 + 0.03, corner + 0.01}), std::hypot(0.03, 0.01),
              1e-12);
  EXPECT_NEAR(physics::hull_distance_local(specs, {0.07, 0}), -0.003, 1e-12);
}

TEST(Placement, ARobotGoesRadiallyByTheLeastDistance) {
  Arena arena({{{0.1, 0.1}, 0}});
  arena.world.push_robots_out({0, 0}, 0.15);
  const truth::Robot robot = arena.robot(0);
  EXPECT_NEAR(robot.position.x(), robot.position.y(), 1e-6);
  EXPECT_NEAR(robot.position.norm(), 0.24, 0.002);
  expect_orderly(arena, {0, 0}, 0.15);
}

TEST(Placement, ThoseThatAreClearStay) {
  Arena arena({{{0.3, 0}, 0}});
  arena.world.push_robots_out({0, 0}, 0.15);
  EXPECT_NEAR(arena.robot(0).position.x(), 0.3, 1e-6);
}

TEST(Placement, SixRobotsOnTheSpot) {
  std::vector<Arena::At> heap;
  for (int i = 0; i < 6; ++i) heap.push_back({Vector2d(0.1 * std::cos(i), 0.1 * std::sin(i)), 1.0 * i});
  heap[0].position = {0, 0};
  Arena arena(heap);
  arena.world.push_robots_out({0, 0}, 0.15);
  expect_orderly(arena, {0, 0}, 0.15);
}

TEST(Placement, InTheCornerAndInTheGoalMouth) {
  for (const Vector2d& spot :
       {Vector2d(4.4, 2.9), Vector2d(4.45, 0), Vector2d(4.9, 3.4), Vector2d(4.4, 0.5)}) {
    std::vector<Arena::At> heap;
    for (int i = 0; i < 4; ++i) heap.push_back({spot + Vector2d(0.02 * i, 0.07 * (i % 2)), 0.5 * i});
    Arena arena(heap);
    arena.world.push_robots_out(spot, 0.15);
    expect_orderly(arena, spot, 0.15);
  }
}

TEST(Placement, AFreshBallOnAFreeSpotStaysThere) {
  Arena arena({{{0, 0}, 0}, {{-1, 0}, 1}});
  arena.shoot({1, 0}, {-8, 0});
  arena.run(0.11);  // in the middle of the hit
  arena.world.push_robots_out({0, 0}, 0.15);
  arena.world.place_ball(Vector2d(0, 0));
  arena.run(1);
  EXPECT_EQ(arena.ball().velocity.norm(), 0);
  EXPECT_EQ(arena.ball().position.x(), 0);
  EXPECT_EQ(arena.ball().position.y(), 0);
}

TEST(Placement, ABallPutIntoARobotGainsNoEnergy) {
  for (int i = 0; i < 12; ++i) {
    Arena arena({{{0, 0}, 0}, {{0.185, 0}, 2}});
    arena.world.place_ball(Vector2d(world::direction(i * M_PI / 6) * 0.008 * i));
    double most = 0;
    for (int k = 0; k < 240; ++k) {
      arena.step();
      most = std::max(most, kinetic_energy(arena));
    }
    // A ball at 0.3 m/s; a pushed-out ball is moved, not shot.
    EXPECT_LT(most, 0.5 * 0.046 * 0.3 * 0.3) << i;
  }
}

// Where a ball may have to be put: in the open, in a goal mouth, before a post, in a corner of the field and
// in one of the walls.
const Vector2d awkward_spots[] = {{0, 0}, {4.45, 0}, {-4.45, 0}, {4.4, 0.5}, {4.4, 2.9}, {5.1, 3.6}};

// `count` robots crowded round a spot without overlapping each other, at least one of them over it, inside
// the walls; they stand off goals' sides and backs.
std::vector<Arena::At> crowd(const Vector2d& spot, int count) {
  std::vector<Arena::At> all;
  const world::Field field;
  const auto fixtures = physics::fixtures(field);
  for (int ring = 0; static_cast<int>(all.size()) < count; ++ring) {
    for (int i = 0; i < std::max(6 * ring, 1) && static_cast<int>(all.size()) < count; ++i) {
      const Vector2d place = spot + 0.19 * ring * world::direction(i * M_PI / (3 * std::max(ring, 1)) + 0.3);
      bool free = std::abs(place.x()) < 5.1 && std::abs(place.y()) < 3.6;
      for (const auto& fixture : fixtures) {
        free = free && (fixture.min.z() > 0.15 || physics::plane_distance(fixture, place) > 0.091);
      }
      if (free) all.push_back({place, 0.7 * static_cast<double>(all.size())});
    }
  }
  return all;
}

// The ball is put on the spot among six robots at rest, with or without moving them out of the way first.
// Nobody is commanded to move, so the drives only brake: whatever kinetic energy there is comes from pushing
// the ball out of a robot, which is to add none. Bullet's own limit is the speed at which it separates an
// overlap; what is seen is a ball that rolls away at less than 0.3 m/s and robots that stay under 1 cm/s.
TEST(Placement, SixRobotsOnAnySpotAddNoEnergy) {
  for (const Vector2d& spot : awkward_spots) {
    for (const bool pushed : {false, true}) {
      Arena arena(crowd(spot, 6));
      arena.run(0.2);
      ASSERT_LT(kinetic_energy(arena), 1e-9);
      if (pushed) {
        arena.world.push_robots_out(spot, 0.15);
        expect_orderly(arena, spot, 0.15);
      }
      arena.world.place_ball(spot);
      double ball = 0, robots = 0;
      for (int i = 0; i < 480; ++i) {
        arena.step();
        ball = std::max(ball, arena.ball().velocity.norm());
        arena.world.read_robots(arena.robots);
        for (const truth::Robot& robot : arena.robots) robots = std::max(robots, robot.velocity.norm());
      }
      EXPECT_LT(ball, pushed ? 1e-9 : 0.3) << spot.transpose();
      EXPECT_LT(robots, pushed ? 1e-9 : 0.01) << spot.transpose();
      if (!pushed) {
        EXPECT_GT(arena.world.distance_to_robots(arena.ball().position.head<2>()), 0.0215 - 0.002);
      }
      EXPECT_LT(std::abs(arena.ball().position.x()), 5.2);
      EXPECT_LT(std::abs(arena.ball().position.y()), 3.7);
    }
  }
}

// The same with robots that move and fight for the ball: the drives may put in what they can, force times
// speed, and nobody gets faster than its drive makes it.
TEST(Placement, AResetInTheMiddleOfAScrumAddsNoMoreThanTheDrives) {
  for (const Vector2d& spot : awkward_spots) {
    Arena arena(crowd(spot, 6));
    for (std::size_t i = 0; i < 6; ++i) {
      world::RobotCommand command;
      command.velocity_local = {i % 2 == 0 ? 1.0 : -0.5, 0.3};
      command.angular_velocity = i % 3 == 0 ? 3 : -2;
      arena.world.set_command(i, command);
    }
    arena.run(0.5);
    arena.world.place_ball(spot);
    const double mass = 2.5, most_force = mass * 6;
    double before = kinetic_energy(arena);
    for (int i = 0; i < 240; ++i) {
      double power = 0;
      for (const truth::Robot& robot : arena.robots) power += most_force * (robot.velocity.norm() + 0.025);
      arena.step();
      const double now = kinetic_energy(arena);
      ASSERT_LT(now, before + power * world::substep_length) << i;
      ASSERT_LT(arena.ball().velocity.norm(), 3);  // pushed by robots at 1.1 m/s, restitution .6
      before = now;
    }
  }
}

TEST(Placement, ABallPutIntoARobotComesOutOfIt) {
  for (int i = 0; i < 40; ++i) {
    Arena arena({{{0, 0}, 0.7}});
    const Vector2d inside = 0.09 * (i % 10) / 10 * world::direction(i);
    arena.world.place_ball(inside);
    arena.run(0.5);
    EXPECT_GT(arena.world.distance_to_robots(arena.ball().position.head<2>()), 0.0215 - 0.002) << i;
    EXPECT_LT(arena.ball().position.head<2>().norm(), 0.115) << i;  // and lies beside it
    EXPECT_NEAR(arena.ball().position.z(), 0.0215, 1e-6) << i;
  }
}

TEST(Placement, RemovedRobotsLeaveAndComeBack) {
  Arena arena({{{0, 0}, 0}, {{1, 0}, 0}});
  arena.world.remove_robot(0);
  arena.world.remove_robot(0);
  arena.roll({-0.5, 0}, {2, 0});
  arena.run(0.4);
  EXPECT_TRUE(arena.contacts.empty());  // it went through where the robot was
  EXPECT_EQ(arena.robot(0).id.number, 1);
  arena.world.put_robot(0, {0, 1}, 2);
  EXPECT_EQ(arena.robot(0).id.number, 0);
  EXPECT_NEAR(arena.robot(0).orientation, 2, 1e-6);
}

}  // namespace
