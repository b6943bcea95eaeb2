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
    return (physics::driven({from, 0}, {to, 0}, {1, 0}, specs, h).velocity - from).norm() / h;
  };
  EXPECT_NEAR(change({2, 0}, {3, 0}), 3, 1e-9);
  EXPECT_NEAR(change({2, 0}, {0, 0}), 6, 1e-9);
  EXPECT_NEAR(change({2, 0}, {2, 2}), 3, 1e-9);
  EXPECT_NEAR(change({2, 0}, {1, 1}), 1 / std::sqrt(0.5 / 36 + 0.5 / 9), 1e-9);
}

// All limits different, so that a mix-up shows.
world::RobotSpecs uneven() {
  world::RobotSpecs specs;
  specs.max_speed = 3;
  specs.max_speed_sideways = 2;
  specs.max_acceleration = 4;
  specs.max_acceleration_sideways = 2.5;
  specs.max_brake = 6;
  specs.max_brake_sideways = 5;
  specs.max_angular_speed = 10;
  specs.max_angular_acceleration = 40;
  specs.max_angular_brake = 80;
  return specs;
}

// Up to full speed, cruise, brake to rest: the times are whole numbers of substeps for these numbers, so the
// place agrees to the rounding of floats near 2 m (0.24 um in each of some 400 substeps, mostly cancelling).
void expect_trapezoid(double heading, const Vector2d& along, double speed, double acceleration,
                      double brake) {
  const Vector2d direction = world::rotated(along, heading);
  Arena arena({{direction * -2, heading}}, uneven());
  arena.world.place_ball(Vector2d(4, -3));  // out of the way
  const double up = speed / acceleration, cruise = 0.5, down = speed / brake;
  const Vector2d ahead = along * 10;  // asks for more than it can: the limit of speed holds
  arena.world.set_command(0, go(ahead.x(), ahead.y()));
  arena.run(up);
  EXPECT_NEAR(arena.robot(0).velocity.dot(direction), speed, 1e-4);
  arena.run(cruise);
  arena.world.set_command(0, go(0));
  arena.run(down);
  EXPECT_NEAR(arena.robot(0).velocity.norm(), 0, 1e-4);
  const double distance = speed * (up / 2 + cruise + down / 2);
  EXPECT_NEAR((arena.robot(0).position - direction * (distance - 2)).norm(), 0, 2e-5);
}

TEST(Drive, ForwardAndSidewaysLimitsMakeTheirOwnTrapezoids) {
  for (const double heading : {0.0, 0.7, -2.0}) {
    expect_trapezoid(heading, {1, 0}, 3, 4, 6);
    expect_trapezoid(heading, {-1, 0}, 3, 4, 6);
    expect_trapezoid(heading, {0, 1}, 2, 2.5, 5);
    expect_trapezoid(heading, {0, -1}, 2, 2.5, 5);
  }
}

TEST(Drive, TurningMakesATrapezoidOfItsOwn) {
  // 10 rad/s after 0.25 s, 0.4 s of it, braked in 0.125 s.
  Arena arena({{{0, 0}, -3}}, uneven());
  arena.world.set_command(0, go(0, 0, 100));
  arena.run(0.25);
  EXPECT_NEAR(arena.robot(0).angular_velocity, 10, 1e-4);
  arena.run(0.4);
  arena.world.set_command(0, go(0));
  arena.run(0.125);
  EXPECT_NEAR(arena.robot(0).angular_velocity, 0, 1e-4);
  const double angle = -3 + 10 * (0.25 / 2 + 0.4 + 0.125 / 2);
  EXPECT_NEAR(world::wrap_angle(arena.robot(0).orientation - angle), 0, 1e-4);
}

TEST(Drive, ATurnThatIsReversedIsBrakedFirst) {
  world::RobotSpecs specs = uneven();
  const double h = world::substep_length;
  const auto turn = [&](double now, double wanted) {
    return physics::driven({{0, 0}, now}, {{0, 0}, wanted}, {1, 0}, specs, h).angular_velocity;
  };
  EXPECT_NEAR(turn(5, -5), 5 - 80 * h, 1e-12);
  EXPECT_NEAR(turn(-5, 5), -5 + 80 * h, 1e-12);
  EXPECT_NEAR(turn(5, 9), 5 + 40 * h, 1e-12);
  EXPECT_NEAR(turn(0, -9), -40 * h, 1e-12);
  EXPECT_NEAR(turn(5, 4.99), 4.99, 1e-12);
}

TEST(Drive, LimitsAreEllipsesInTheRobotsFrame) {
  const world::RobotSpecs specs = uneven();
  const double h = world::substep_length;
  const double heading = 0.4;
  const Vector2d forward = world::direction(heading);
  for (int i = 0; i < 36; ++i) {
    const double angle = i * M_PI / 18;
    const Vector2d direction = world::direction(angle + heading);
    // Parametric against polar form: the end of the vector must lie on the ellipse.
    const auto on_ellipse = [&](const Vector2d& vector, double along, double across) {
      const Vector2d local = world::rotated(vector, -heading);
      return std::pow(local.x() / along, 2) + std::pow(local.y() / across, 2);
    };
    const auto after = [&](const Vector2d& from, const Vector2d& to, double time) {
      return physics::driven({from, 0}, {to, 0}, forward, specs, time).velocity;
    };
    EXPECT_NEAR(on_ellipse(after({0, 0}, direction * 20, 100), 3, 2), 1, 1e-9) << i;
    EXPECT_NEAR(on_ellipse(after({0, 0}, direction * 20, h) / h, 4, 2.5), 1, 1e-9) << i;
    EXPECT_NEAR(on_ellipse((after(direction, -direction, h) - direction) / h, 6, 5), 1, 1e-9) << i;
  }
}

TEST(Drive, NothingJumpsWhenTheDirectionTurns) {
  // From speeding up over going across to braking: neighbouring directions get neighbouring limits.
  const world::RobotSpecs specs = uneven();
  const double h = world::substep_length;
  double before = 0;
  for (int i = 0; i <= 3600; ++i) {
    const Vector2d velocity = world::direction(0.3);
    const Vector2d asked = velocity + 0.5 * world::direction(i * M_PI / 1800);
    const double limit =
        (physics::driven({velocity, 0}, {asked, 0}, {1, 0}, specs, h).velocity - velocity).norm() / h;
    if (i > 0) {
      EXPECT_NEAR(limit, before, 0.02) << i;  // the ellipses change by up to 7 m/s^2 per radian
    }
    before = limit;
  }
}

TEST(Drive, EqualLimitsTakeTheCircleAndUnequalOnesTendToIt) {
  world::RobotSpecs circle, nearly;
  for (double* limit :
       {&nearly.max_speed_sideways, &nearly.max_acceleration_sideways, &nearly.max_brake_sideways}) {
    *limit *= 1 + 1e-12;
  }
  for (int i = 0; i < 50; ++i) {
    const Vector2d now = 2 * world::direction(i), asked = 4 * world::direction(2.7 * i);
    const Vector2d a =
        physics::driven({now, 0}, {asked, 0}, world::direction(i * 0.3), circle, 0.01).velocity;
    const Vector2d b =
        physics::driven({now, 0}, {asked, 0}, world::direction(i * 0.3), nearly, 0.01).velocity;
    EXPECT_LT((a - b).norm(), 1e-11);  // two ways to compute the same
  }
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
  // At factor f both speed and acceleration are multiplied by f. The same path takes 1/f of the time only at
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

TEST(Drive, PushesABlockedRobotWithNoMoreThanItsAcceleration) {
  // 3 m/s^2 of 2.5 kg against a wall: the reported speed stays below one substep's change.
  Arena arena({{{5.0, 0}, 0}});
  arena.world.set_command(0, go(3));
  arena.run(2);
  EXPECT_LT(arena.robot(0).velocity.norm(), 3 * world::substep_length);
  EXPECT_NEAR(arena.robot(0).position.x() + 0.073, 5.2, 2e-3);  // the flat front lies on the wall
}

}  // namespace
