#include "sim/physics/dribbler.h"

#include <gtest/gtest.h>

#include "tests/sim/physics/arena.h"

namespace {

using world::Vector2d;

constexpr double at_front = 0.073 + 0.0215;

// Starts with the ball held at rest, then drives as commanded; returns whether it is still held afterwards.
bool still_held(const Vector2d& velocity, double turn, double seconds, const world::RobotSpecs& like = {},
                bool then_stop = false) {
  Arena arena({{{0, 0}, 0}}, like);
  arena.world.place_ball(Vector2d(at_front, 0));
  world::RobotCommand command;
  command.dribbler_speed = 100;
  arena.world.set_command(0, command);
  arena.run(0.1);
  command.velocity_local = velocity;
  command.angular_velocity = turn;
  arena.world.set_command(0, command);
  arena.run(seconds);
  if (then_stop) {
    command.velocity_local.setZero();
    command.angular_velocity = 0;
    arena.world.set_command(0, command);
    arena.run(1);
  }
  return arena.robot(0).ball_contact;
}

TEST(Dribbler, HoldsTheBallWhileDrivingForward) { EXPECT_TRUE(still_held({2, 0}, 0, 1.5)); }
TEST(Dribbler, HoldsTheBallWhileDrivingBackwardsGently) {
  // The robot itself accelerates at 3 m/s^2, the bar pulls up to 5.
  EXPECT_TRUE(still_held({-1, 0}, 0, 2));
}
TEST(Dribbler, HoldsTheBallWhileTurningInPlace) {
  EXPECT_TRUE(still_held({0, 0}, 2, 3));
  EXPECT_TRUE(still_held({0, 0}, -3, 3));
}
TEST(Dribbler, HoldsTheBallOnAWideArc) { EXPECT_TRUE(still_held({1, 0}, 2, 3)); }

TEST(Dribbler, LosesTheBallWhenTurningTooFast) { EXPECT_FALSE(still_held({0, 0}, 12, 1)); }
TEST(Dribbler, LosesTheBallWhenBrakingTooHard) {
  EXPECT_FALSE(still_held({2, 0}, 0, 1, {}, true));  // full brake is 6 m/s^2
}
TEST(Dribbler, KeepsTheBallWhenBrakingGently) {
  world::RobotSpecs gentle;
  gentle.max_brake = 4;
  EXPECT_TRUE(still_held({2, 0}, 0, 1, gentle, true));
}

// The first of rising values, in steps of 0.25, at which the ball is lost.
template <class Holds>
double first_lost(double from, Holds holds) {
  double value = from;
  while (value < 20 && holds(value)) value += 0.25;
  return value;
}

// Bounds from `pull`, 5 m/s^2: turning in place needs w^2 rho with rho = 94.5 mm, so 7.3 rad/s; driving off
// backwards and braking need their acceleration, and the grip reaches over 15 mm, which lets a little more
// pass.
TEST(Dribbler, LosesTheBallWhereTheReadmeSays) {
  const double turn = first_lost(1, [](double rate) { return still_held({0, 0}, rate, 2); });
  EXPECT_NEAR(turn, 7.5, 0.25);
  const double backwards = first_lost(1, [](double acceleration) {
    world::RobotSpecs specs;
    specs.max_acceleration = acceleration;
    return still_held({-1.5, 0}, 0, 1, specs);
  });
  EXPECT_NEAR(backwards, 5.5, 0.25);
  const double brake = first_lost(1, [](double deceleration) {
    world::RobotSpecs specs;
    specs.max_brake = deceleration;
    return still_held({2, 0}, 0, 1, specs, true);
  });
  EXPECT_NEAR(brake, 5.5, 0.25);
}

TEST(Dribbler, CatchesAPass) {
  Arena arena({{{0, 0}, 0}});
  world::RobotCommand command;
  command.dribbler_speed = 100;
  arena.world.set_command(0, command);
  arena.roll({1, 0}, {-3, 0});
  arena.run(1.5);
  EXPECT_TRUE(arena.robot(0).ball_contact);
}

TEST(Dribbler, DoesNothingWhenItStands) {
  Arena arena({{{0, 0}, 0}});
  arena.roll({1, 0}, {-3, 0});
  arena.run(1.5);
  EXPECT_FALSE(arena.robot(0).ball_contact);
}

TEST(Dribbler, LetsGoOfAKickedBall) {
  Arena arena({{{0, 0}, 0}});
  arena.world.place_ball(Vector2d(at_front, 0));
  world::RobotCommand command;
  command.dribbler_speed = 100;
  arena.world.set_command(0, command);
  arena.run(0.2);
  command.kick_speed = 3;
  arena.world.set_command(0, command);
  arena.run(0.05);
  ASSERT_EQ(arena.kicks.size(), 1U);
  EXPECT_NEAR(arena.ball().velocity.x(), 3 - 3.0 * 0.05, 0.02);  // slides freely
}

TEST(Dribbler, HoldingIsAContact) {
  Arena arena({{{0, 0}, 0}});
  arena.world.place_ball(Vector2d(at_front + 0.004, 0.01));
  world::RobotCommand command;
  command.dribbler_speed = 100;
  command.velocity_local = {-0.5, 0};
  arena.world.set_command(0, command);
  arena.run(0.3);
  EXPECT_GT(arena.contacts.size(), 60U);  // of 72 substeps
}

TEST(Dribbler, GripGrowsWithSpeedUpToFull) {
  const physics::DribblerParams params;
  EXPECT_EQ(physics::grip(-100, params), 0);
  EXPECT_EQ(physics::grip(0, params), 0);
  EXPECT_NEAR(physics::grip(25, params), 0.5, 1e-12);
  EXPECT_EQ(physics::grip(500, params), 1);
}

TEST(Dribbler, TwoRobotsContestTheBallWithoutNonsense) {
  Arena arena({{{-at_front, 0}, 0}, {{at_front, 0}, M_PI}});
  arena.world.place_ball(Vector2d(0, 0));
  world::RobotCommand command;
  command.dribbler_speed = 100;
  command.velocity_local = {1, 0};
  arena.world.set_command(0, command);
  command.velocity_local = {-1, 0.3};
  command.angular_velocity = 2;
  arena.world.set_command(1, command);
  for (int i = 0; i < 480; ++i) {
    arena.step();
    ASSERT_LT(arena.ball().velocity.norm(), 4) << i;
    ASSERT_TRUE(arena.ball().position.allFinite());
  }
}

}  // namespace
