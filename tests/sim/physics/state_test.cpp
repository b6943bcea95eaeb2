#include "sim/physics/state.h"

#include <gtest/gtest.h>

#include "sim/world/random.h"
#include "tests/sim/physics/arena.h"

namespace {

using world::Vector2d;

physics::Params with_errors() {
  physics::Params params;
  params.actuators.kick_direction_sigma = 0.02;
  params.actuators.kick_speed_sigma = 0.05;
  params.actuators.misfire = 0.05;
  params.actuators.grip_sigma = 0.1;
  params.actuators.speed_sigma = 0.02;
  params.actuators.heading_drift_sigma = 0.02;
  return params;
}

std::vector<Arena::At> line_up() {
  std::vector<Arena::At> all;
  for (int i = 0; i < 12; ++i) {
    const double s = i < 6 ? -1 : 1;
    all.push_back({{s * (1 + i % 3), i % 6 < 3 ? 1.0 : -1.0}, i < 6 ? 0 : M_PI});
  }
  return all;
}

// Everyone runs at the ball and kicks or dribbles it: many contacts. Depends on tick and truth only.
void crowd_tick(Arena& arena, int tick) {
  arena.world.read_robots(arena.robots);
  const Vector2d ball = arena.ball().position.head<2>();
  for (std::size_t i = 0; i < arena.robots.size(); ++i) {
    const truth::Robot& robot = arena.robots[i];
    const Vector2d way =
        ball + 0.4 * world::direction(static_cast<double>(i)) * (i % 4 == 0 ? 0 : 1) - robot.position;
    world::RobotCommand command;
    command.velocity_local = world::rotated(way * 3, -robot.orientation);
    command.angular_velocity =
        6 * world::wrap_angle(world::angle_of(ball - robot.position) - robot.orientation);
    command.kick_speed = tick % 40 < 20 ? 3 : 0;
    command.dribbler_speed = 100;
    arena.world.set_command(i, command);
  }
  for (int k = 0; k < 4; ++k) arena.step();
}

void expect_same(Arena& a, Arena& b, int when) {
  ASSERT_EQ(a.ball().position, b.ball().position) << when;
  ASSERT_EQ(a.ball().velocity, b.ball().velocity) << when;
  ASSERT_EQ(a.ball().spin, b.ball().spin) << when;
  a.world.read_robots(a.robots);
  b.world.read_robots(b.robots);
  ASSERT_EQ(a.robots.size(), b.robots.size());
  for (std::size_t i = 0; i < a.robots.size(); ++i) {
    ASSERT_EQ(a.robots[i].position, b.robots[i].position) << when;
    ASSERT_EQ(a.robots[i].orientation, b.robots[i].orientation) << when;
    ASSERT_EQ(a.robots[i].velocity, b.robots[i].velocity) << when;
    ASSERT_EQ(a.robots[i].angular_velocity, b.robots[i].angular_velocity) << when;
  }
}

TEST(State, WorldsThatRestoreItContinueAlikeToTheBit) {
  Arena original(line_up(), {}, with_errors(), 4);
  for (int tick = 0; tick < 300; ++tick) crowd_tick(original, tick);
  const physics::State state = original.world.state();
  Arena a(line_up(), {}, with_errors(), 4), b(line_up(), {}, with_errors(), 4);
  for (int tick = 0; tick < 100; ++tick) crowd_tick(b, tick);  // a history that must not matter
  b.world.remove_robot(2);
  a.world.restore(state);
  b.world.restore(state);
  for (int tick = 300; tick < 900; ++tick) {
    crowd_tick(a, tick);
    crowd_tick(b, tick);
    ASSERT_NO_FATAL_FAILURE(expect_same(a, b, tick));
  }
  EXPECT_GT(a.kicks.size(), 3U);
}

TEST(State, MotionWithoutTouchContinuesAsTheOriginalDoes) {
  // A chip that bounces and rolls, three robots that drive curves, one that turns and one that is off the
  // field; taken at a moment in the middle of everything.
  Arena original({{{-3, -2}, 0.3}, {{3, -2}, -2}, {{0, 2.5}, 1}, {{-3, 2}, 0}}, {}, with_errors(), 11);
  original.world.remove_robot(3);
  original.place({-1, 0, 0.0215}, {1.5, 0.7, 3});
  const auto tick = [](Arena& arena, int i) {
    world::RobotCommand command;
    command.velocity_local = {1.2 * std::sin(0.05 * i), 0.8 * std::cos(0.03 * i)};
    command.angular_velocity = 4 * std::sin(0.1 * i);
    for (std::size_t k = 0; k < 3; ++k) arena.world.set_command(k, command);
    for (int k = 0; k < 4; ++k) arena.step();
  };
  for (int i = 0; i < 20; ++i) tick(original, i);
  Arena restored({{{0, 0}, 0}, {{1, 0}, 0}, {{2, 0}, 0}, {{-2, 0}, 0}}, {}, with_errors(), 11);
  restored.world.restore(original.world.state());
  EXPECT_FALSE(restored.world.is_present(3));
  for (int i = 20; i < 140; ++i) {
    tick(original, i);
    tick(restored, i);
    ASSERT_NO_FATAL_FAILURE(expect_same(original, restored, i));
  }
  EXPECT_TRUE(original.contacts.empty());
}

TEST(State, IsWhatWasRestored) {
  Arena original(line_up(), {}, with_errors(), 4);
  for (int tick = 0; tick < 120; ++tick) crowd_tick(original, tick);
  const physics::State state = original.world.state();
  Arena other(line_up(), {}, with_errors(), 4);
  other.world.restore(state);
  const physics::State again = other.world.state();
  EXPECT_EQ(state.ball.position, again.ball.position);
  EXPECT_EQ(state.ball_pose, again.ball_pose);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(state.robots[i].pose, again.robots[i].pose);
    EXPECT_EQ(state.robots[i].velocity, again.robots[i].velocity);
    EXPECT_EQ(state.robots[i].memory.kicks, again.robots[i].memory.kicks);
    EXPECT_EQ(state.robots[i].memory.recharging, again.robots[i].memory.recharging);
    EXPECT_EQ(state.robots[i].memory.command.velocity_local, again.robots[i].memory.command.velocity_local);
  }
}

TEST(State, ARestoredTouchStaysCloseToTheOriginal) {
  // In the middle of a touch the restored world lacks the contact's warm start: what differs is the rounding
  // of a solver that has converged. A ball being pushed by a robot, one second later.
  Arena original({{{0, 0}, 0}});
  original.world.place_ball(Vector2d(0.12, 0.01));
  world::RobotCommand command;
  command.velocity_local = {1, 0};
  original.world.set_command(0, command);
  original.run(0.5);
  Arena restored({{{0, 0}, 0}});
  restored.world.restore(original.world.state());
  original.run(1);
  restored.run(1);
  EXPECT_LT((original.ball().position - restored.ball().position).norm(), 1e-3);
  EXPECT_LT((original.robot(0).position - restored.robot(0).position).norm(), 1e-4);
}

}  // namespace
