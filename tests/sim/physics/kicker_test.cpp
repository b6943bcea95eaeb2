#include "sim/physics/kicker.h"

#include <gtest/gtest.h>

#include "tests/sim/physics/arena.h"

namespace {

using world::Vector2d;

world::RobotCommand kick(double speed, double angle = 0) {
  world::RobotCommand command;
  command.kick_speed = speed;
  command.kick_angle = angle;
  return command;
}

// The ball touching the front of a robot at the origin that looks along x.
constexpr double at_front = 0.073 + 0.0215;

TEST(Kicker, GivesTheCommandedSpeedAlongTheHeading) {
  for (const double heading : {0.0, 1.0, -2.5}) {
    Arena arena({{{0, 0}, heading}});
    arena.world.place_ball(Vector2d(world::direction(heading) * at_front));
    arena.world.set_command(0, kick(5));
    arena.step();
    ASSERT_EQ(arena.kicks.size(), 1U);
    const truth::Kick& fired = arena.kicks[0];
    EXPECT_EQ(fired.robot, arena.specs[0].id);
    EXPECT_EQ(fired.time, world::tick_time(0, 1));
    EXPECT_NEAR(fired.velocity.norm(), 5, 1e-6);
    EXPECT_NEAR(world::angle_of(fired.velocity.head<2>()), heading, 1e-6);
    ASSERT_EQ(arena.contacts.size(), 1U);  // a kick is a touch
    EXPECT_NEAR(arena.contacts[0].impulse, 0.046 * 5, 0.01);
  }
}

TEST(Kicker, ChipsWithTheAbsoluteSpeedAtTheAngle) {
  Arena arena({{{-4, 0}, 0}});
  arena.world.place_ball(Vector2d(-4 + at_front, 0));
  arena.world.set_command(0, kick(5, M_PI / 4));
  arena.step();
  ASSERT_EQ(arena.kicks.size(), 1U);
  EXPECT_NEAR(arena.kicks[0].velocity.norm(), 5, 1e-6);
  EXPECT_NEAR(arena.kicks[0].velocity.z(), 5 / std::sqrt(2.0), 1e-6);
  double apex = 0;
  for (int i = 0; i < 240; ++i) {
    arena.step();
    apex = std::max(apex, arena.ball().position.z());
  }
  EXPECT_NEAR(apex - arena.field.ball_radius, 12.5 / (2 * physics::gravity), 1e-3);
}

TEST(Kicker, CapsFlatKicksAndChips) {
  Arena flat({{{0, 0}, 0}}), chip({{{0, 0}, 0}});
  for (auto* arena : {&flat, &chip}) arena->world.place_ball(Vector2d(at_front, 0));
  flat.world.set_command(0, kick(50));
  chip.world.set_command(0, kick(50, 0.5));
  flat.step();
  chip.step();
  EXPECT_NEAR(flat.kicks.at(0).velocity.norm(), 10, 1e-6);
  EXPECT_NEAR(chip.kicks.at(0).velocity.norm(), 6, 1e-6);
}

TEST(Kicker, NeedsTheBallBeforeTheFront) {
  const Vector2d misses[] = {{at_front + 0.010, 0},  // out of reach
                             {at_front, 0.040},      // beside the dribbler
                             {-at_front, 0}};        // behind
  for (const Vector2d& spot : misses) {
    Arena arena({{{0, 0}, 0}});
    arena.world.place_ball(spot);
    arena.world.set_command(0, kick(5));
    arena.step();
    EXPECT_TRUE(arena.kicks.empty()) << spot.transpose();
    EXPECT_FALSE(arena.robot(0).ball_contact);
  }
  Arena high({{{0, 0}, 0}});
  truth::Ball ball;
  ball.position = {at_front, 0, 0.08};
  high.world.place_ball(ball);
  high.world.set_command(0, kick(5));
  high.step();
  EXPECT_TRUE(high.kicks.empty());
}

TEST(Kicker, BreakBeamSeesTheBallAtTheFront) {
  Arena arena({{{0, 0}, 0}});
  arena.world.place_ball(Vector2d(at_front + 0.002, 0.01));
  EXPECT_TRUE(arena.robot(0).ball_contact);
}

TEST(Kicker, RechargesForATenthOfASecond) {
  Arena arena({{{0, 0}, 0}});
  arena.world.set_command(0, kick(2));
  for (int i = 0; i < 60; ++i) {
    arena.world.place_ball(Vector2d(at_front, 0));
    arena.step();
  }
  ASSERT_EQ(arena.kicks.size(), 3U);  // at 0, 24 and 48 substeps
  EXPECT_NEAR(world::seconds(arena.kicks[1].time - arena.kicks[0].time), 0.1, 1e-6);
}

TEST(Kicker, KeepsTheRobotsSidewaysMotionInTheDirectionOnly) {
  Arena arena({{{0, 0}, 0}});
  arena.world.set_motion(0, {1, 0.5}, 0);
  world::RobotCommand command = kick(4);
  command.velocity_local = {1, 0.5};
  arena.world.set_command(0, command);
  arena.world.place_ball(Vector2d(at_front, 0));
  arena.step();
  ASSERT_EQ(arena.kicks.size(), 1U);
  EXPECT_NEAR(arena.kicks[0].velocity.norm(), 4, 1e-6);
  EXPECT_NEAR(arena.kicks[0].velocity.y() / arena.kicks[0].velocity.x(), 0.5 / 4, 1e-4);
}

TEST(Kicker, KickAndRecoilHaveTheSameMomentum) {
  Arena arena({{{0, 0}, 0}});
  arena.world.place_ball(Vector2d(at_front, 0));
  arena.world.set_command(0, kick(8));
  arena.step();
  // The drive works against the recoil with up to 6 m/s^2 in both halves of the substep.
  EXPECT_NEAR(arena.robot(0).velocity.x(), -8 * 0.046 / 2.5, 6 * world::substep_length);
}

}  // namespace
