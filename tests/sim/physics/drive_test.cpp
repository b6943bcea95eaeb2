#include "sim/physics/drive.h"

#include <gtest/gtest.h>

#include "tests/sim/physics/arena.h"

namespace {

using physics::Motion;
using world::Vector2d;

world::RobotCommand go(double forward, double left = 0, double turn = 0) {
  world::RobotCommand command;
  command.velocity_local = {forward, left};
  command.angular_velocity = turn;
  return command;
}

TEST(Drive, SpeedsUpAtItsAccelerationFromRest) {
  Arena arena({{{-4, 0}, 0}});
  arena.world.set_command(0, go(2));
  arena.run(0.5);
  const truth::Robot robot = arena.robot(0);
  EXPECT_NEAR(robot.velocity.x(), 1.5, 1e-5);         // 3 m/s^2
  EXPECT_NEAR(robot.position.x(), -4 + 0.375, 1e-4);  // a t^2 / 2, floats near 4 m
}

TEST(Drive, ReachesAPointInTheTimeOfATrapezoid) {
  // 4 m at 3 m/s^2 up to 3 m/s, then at full brake of 6 m/s^2 to rest.
  const double up = 1.0, down = 0.5, cruise = (4 - 1.5 - 0.75) / 3;
  Arena arena({{{-2, 0}, 0}});
  arena.world.set_command(0, go(3));
  arena.run(up + cruise);
  const double late = up + cruise - arena.time();  // substeps are whole
  arena.world.set_command(0, go(0));
  arena.run(down);
  EXPECT_NEAR(arena.robot(0).velocity.x(), 0, 1e-5);
  EXPECT_NEAR(arena.robot(0).position.x(), 2 - 3 * late, 2e-4);  // floats near 2 m
}

TEST(Drive, ClampsTheSpeedVectorNotItsComponents) {
  Arena arena({{{0, 0}, 0}});
  arena.world.set_command(0, go(3, 3));
  arena.run(1.2);
  EXPECT_NEAR(arena.robot(0).velocity.norm(), 3, 1e-5);
  EXPECT_NEAR(arena.robot(0).velocity.x(), arena.robot(0).velocity.y(), 1e-5);
}

TEST(Drive, BrakesOnAnEllipseOfBrakeAndAcceleration) {
  const world::RobotSpecs specs;
  const double h = 1.0 / 240;
  const auto change = [&](const Vector2d& from, const Vector2d& to) {
    return (physics::driven({from, 0}, {to, 0}, specs, h).velocity - from).norm() / h;
  };
  EXPECT_NEAR(change({2, 0}, {3, 0}), 3, 1e-9);
  EXPECT_NEAR(change({2, 0}, {0, 0}), 6, 1e-9);
  EXPECT_NEAR(change({2, 0}, {2, 2}), 3, 1e-9);
  EXPECT_NEAR(change({2, 0}, {1, 1}), 1 / std::sqrt(0.5 / 36 + 0.5 / 9), 1e-9);
}

TEST(Drive, TurnsUnderItsLimits) {
  Arena arena({{{0, 0}, 0}});
  arena.world.set_command(0, go(0, 0, 100));
  arena.run(0.2);
  EXPECT_NEAR(arena.robot(0).angular_velocity, 10, 1e-4);  // 50 rad/s^2
  EXPECT_NEAR(arena.robot(0).orientation, 0.5 * 50 * 0.04, 1e-4);
  arena.run(0.4);
  EXPECT_NEAR(arena.robot(0).angular_velocity, 20, 1e-4);
}

TEST(Drive, LocalVelocityMakesACircle) {
  // 1 m/s forward at 1 rad/s: a circle of 1 m radius, closed after 2 pi seconds.
  Arena arena({{{0, 0}, 0}});
  arena.world.set_motion(0, {1, 0}, 1);
  arena.world.set_command(0, go(1, 0, 1));
  arena.run(2 * M_PI);
  EXPECT_NEAR(arena.robot(0).position.norm(), 0,
              2e-3);  // 2 pi is not a whole number of substeps: up to 2.1 mm
}

TEST(Drive, ASlowedRobotTakesOneOverTheFactor) {
  // At factor f speed and acceleration are both f times: the same path with time stretched... only for pure
  // cruising; from rest over distance d with acceleration a the time is sqrt(2 d / a), so it takes 1/sqrt(f).
  // Cruise is tested here.
  for (const double factor : {0.5, 0.25}) {
    Arena arena({{{-4, 0}, 0}}, world::slowed({}, factor));
    arena.world.set_motion(0, {3 * factor, 0}, 0);
    arena.world.set_command(0, go(3));
    const double full_time = 6.0 / 3.0;
    arena.run(full_time / factor);
    EXPECT_NEAR(arena.robot(0).position.x(), 2, 1e-3);
    EXPECT_NEAR(arena.robot(0).velocity.norm(), 3 * factor, 1e-5);
  }
}

TEST(Drive, RobotMirroredByHalfATurnGoesTheMirroredWay) {
  // Not to the bit: a heading of pi has a sine of 1e-7 in single precision, not 0.
  Arena one({{{-1, 0.5}, 0.3}}), other({{{1, -0.5}, 0.3 + M_PI}});
  for (int i = 0; i < 1000; ++i) {
    const world::RobotCommand command =
        go(2 * std::sin(i * 0.01), std::cos(i * 0.03), 3 * std::sin(i * 0.02));
    one.world.set_command(0, command);
    other.world.set_command(0, command);
    one.step();
    other.step();
    ASSERT_LT((one.robot(0).position + other.robot(0).position).norm(), 1e-4) << i;
  }
}

TEST(Drive, PushesABlockedRobotWithNoMoreThanItsAcceleration) {
  // 3 m/s^2 of 2.5 kg against a wall: the reported speed stays below one substep's change.
  Arena arena({{{5.0, 0}, 0}});
  arena.world.set_command(0, go(3));
  arena.run(2);
  EXPECT_LT(arena.robot(0).velocity.norm(), 3 * world::substep_length);
  EXPECT_NEAR(arena.robot(0).position.x() + 0.073, 5.2, 2e-3);  // the flat front lies on the wall
}

}  // namespace
