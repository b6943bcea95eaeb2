#include <gtest/gtest.h>

#include "tests/sim/physics/arena.h"

namespace {

using world::Vector2d;

// Coefficient of a head-on hit of a body of mass m on a free one of mass M.
double rebound(double e, double m, double M) { return (e * M - m) / (m + M); }

TEST(Contact, BallReboundsFromAFrontWithRestitutionAndRecoil) {
  for (const double speed : {2.0, 5.0, 8.0}) {
    Arena arena({{{0, 0}, 0}});
    arena.roll({0.5, 0}, {-speed, 0});
    double before = 0;
    while (arena.contacts.empty()) {
      before = arena.ball().velocity.x();
      arena.step();
    }
    arena.step();
    // 0.26 m/s^2 over two substeps, and the drive of the robot that has started to stop itself.
    EXPECT_NEAR(-arena.ball().velocity.x() / before, rebound(0.6, 0.046, 2.5), 0.01) << speed;
    EXPECT_NEAR(arena.contacts[0].impulse, 0.046 * speed * 1.571, 0.01) << speed;
  }
}

TEST(Contact, BallReboundsFromTheRoundSideAlongItsNormal) {
  Arena arena({{{0, 0}, M_PI}});
  arena.roll({0.5, 0}, {-4, 0});
  arena.run(0.15);
  EXPECT_GT(arena.ball().velocity.x(), 2);
  EXPECT_LT(std::abs(arena.ball().velocity.y()), 0.02);  // 14 pieces: the middle one lies opposite the front
}

TEST(Contact, BallReboundsFromAWall) {
  Arena arena;
  arena.roll({0, 3.5}, {0, 3});
  arena.run(0.15);
  EXPECT_NEAR(-arena.ball().velocity.y() / 3, 0.3, 0.02);  // .26 to 3 m/s^2 of friction for 0.1 s after it
}

TEST(Contact, GoalBackStopsTheBall) {
  Arena arena;
  arena.roll({4.3, 0}, {5, 0});
  arena.run(0.3);
  EXPECT_LT(arena.ball().position.x(), 4.5 + 0.18 - 0.0215 + 1e-3);
  EXPECT_GT(arena.ball().position.x(), 4.5);  // stays in the goal
}

TEST(Contact, RobotsCollideWithMomentum) {
  // Head-on at restitution 0.1; both drives let go for this by asking for what they would have afterwards.
  Arena arena({{{-0.2, 0}, M_PI / 2}, {{0.2, 0}, -M_PI / 2}});
  arena.world.set_motion(0, {1, 0}, 0);
  arena.world.set_motion(1, {-1, 0}, 0);
  world::RobotCommand on;
  on.velocity_local = {0, -1};  // robot 0 looks up, its right is +x
  arena.world.set_command(0, on);
  arena.world.set_command(1, on);
  for (int i = 0; i < 60; ++i) {
    arena.step();
    const Vector2d sum = arena.robot(0).velocity + arena.robot(1).velocity;
    ASSERT_LT(sum.norm(), 1e-3);
    // Corners of the hulls stick out by 0.7 mm each; pressed with 7.5 N from both sides.
    ASSERT_GT((arena.robot(0).position - arena.robot(1).position).norm(), 0.18 - 0.012);
  }
}

TEST(Contact, RobotsPressedTogetherStayApart) {
  // Six robots in a row against a wall, all pushing with full acceleration for 10 s.
  std::vector<Arena::At> row;
  for (int i = 0; i < 6; ++i) row.push_back({{5.2 - 0.1 - 0.2 * i, 0}, 0});
  Arena arena(row);
  world::RobotCommand push;
  push.velocity_local = {3, 0};
  for (std::size_t i = 0; i < 6; ++i) arena.world.set_command(i, push);
  arena.run(2);  // they gather
  double worst = 0;
  for (int i = 0; i < 8 * 240; ++i) {
    arena.step();
    arena.world.read_robots(arena.robots);
    worst = std::max(worst, arena.robots[0].position.x() + 0.073 - 5.2);
    for (std::size_t a = 0; a < 6; ++a) {
      for (std::size_t b = a + 1; b < 6; ++b) {
        const double gap = (arena.robots[a].position - arena.robots[b].position).norm();
        // Front against round side: 73 + 90 mm; anything less than that is overlap.
        worst = std::max(worst, 0.163 - gap);
      }
    }
  }
  RecordProperty("worst_overlap_mm", std::to_string(worst * 1000));
  EXPECT_LT(worst, 0.005);
}

TEST(Contact, ABallPressedAgainstAWallIsNotSwallowed) {
  Arena arena({{{5.0, 0}, 0}});
  arena.world.place_ball(Vector2d(5.2 - 0.0215, 0.0));
  world::RobotCommand push;
  push.velocity_local = {3, 0};
  arena.world.set_command(0, push);
  for (int i = 0; i < 5 * 240; ++i) {
    arena.step();
    ASSERT_LT(arena.ball().position.x(), 5.2 + 0.0215);  // its centre stays on this side of the wall by far
    ASSERT_LT(arena.ball().position.z(), 0.2);
  }
  const double overlap = 5.2 - arena.robot(0).position.x() - 0.073 - 0.043;
  EXPECT_GT(overlap, -0.01);
}

TEST(Contact, BallFliesOverARobotAndHitsALowerOne) {
  truth::Ball ball;
  ball.velocity = {4, 0, 0};
  for (const bool over : {true, false}) {
    Arena arena({{{1, 0}, 0}});
    ball.position = {0.7, 0, over ? 0.25 : 0.12};
    arena.world.place_ball(ball);
    arena.run(0.1);
    EXPECT_EQ(arena.contacts.empty(), over);
    EXPECT_EQ(arena.ball().velocity.x() > 3.9, over);
  }
}

TEST(Contact, ABallOnARobotRollsOff) {
  Arena arena({{{0, 0}, 0}});
  truth::Ball ball;
  ball.position = {0.01, 0.005, 0.3};
  arena.world.place_ball(ball);
  arena.run(3);
  EXPECT_LT(arena.ball().position.z(), 0.05);
}

TEST(Contact, ABallOnAGoalRollsOff) {
  Arena arena;
  truth::Ball ball;
  ball.position = {4.58, 0.2, 0.4};
  arena.world.place_ball(ball);
  arena.run(4);
  EXPECT_LT(arena.ball().position.z(), 0.05);
}

TEST(Contact, NoneIsReportedWithoutTouch) {
  Arena arena({{{0, 0}, 0}});
  arena.roll({0.115, 0.3}, {0, -2});  // passes the front with 20 mm to spare
  arena.run(0.3);
  EXPECT_TRUE(arena.contacts.empty());
}

TEST(Contact, TimesAndRobotsAreReported) {
  Arena arena({{{0, 0}, 0}, {{2, 0}, 0}});
  arena.roll({0.3, 0}, {-3, 0});
  arena.run(0.2);
  ASSERT_FALSE(arena.contacts.empty());
  for (const truth::Contact& contact : arena.contacts) {
    EXPECT_EQ(contact.robot, arena.specs[0].id);
    EXPECT_GT(contact.impulse, 0);
  }
  const double expected = (0.3 - 0.073 - 0.0215) / 3;
  EXPECT_NEAR(world::seconds(arena.contacts[0].time), expected, 0.008);
}

}  // namespace
