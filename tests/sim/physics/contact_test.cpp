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

// Velocity of the ball in the first substep after which it has turned round along `axis`;
// null if it never does.
world::Vector3d after_rebound(Arena& arena, int axis) {
  const double sign = std::copysign(1.0, arena.ball().velocity[axis]);
  for (int i = 0; i < 240; ++i) {
    arena.step();
    if (arena.ball().velocity[axis] * sign < 0) return arena.ball().velocity;
  }
  return world::Vector3d::Zero();
}

constexpr int phases = 24;

// Shoots a rolling ball from a place 0.1 m before the thing it hits, shifted by parts of what it covers in a
// substep, and compares the share of its normal speed that it has afterwards.
//
// Against what does not move that is e. Bullet takes a contact up to a millimetre before it happens,
// and what is left of the way is then missing from the rebound: so many of the phases may be off,
// and one more at each end of them.
void expect_restitution(const Vector2d& from, const Vector2d& direction, double speed, double e) {
  int exact = 0;
  for (int phase = 0; phase < phases; ++phase) {
    Arena arena;
    arena.roll(from - direction * (speed * world::substep_length * phase / phases), direction * speed);
    double before = 0, after = 1;
    while (after > 0) {
      before = arena.ball().velocity.head<2>().dot(direction);
      arena.step();
      after = arena.ball().velocity.head<2>().dot(direction);
    }
    const double share = -after / before;
    // The carpet takes up to 3 m/s^2 in the substep of the hit: 0.0125 m/s.
    const double tolerance = 0.0125 / speed + 0.002;
    EXPECT_LT(share, e + tolerance + 0.04) << speed << " phase " << phase;  // never much too fast
    exact += std::abs(share - e) < tolerance ? 1 : 0;
  }
  const double early = 0.001 / (speed * world::substep_length);
  EXPECT_GE(exact, phases * (1 - early) - 2) << speed << " along " << direction.transpose();
}

TEST(Contact, BallReboundsFromWallsByTheirRestitution) {
  for (const double speed : {1.0, 3.0, 6.0, 8.0}) {
    expect_restitution({0.3, 3.6}, {0, 1}, speed, 0.3);
    expect_restitution({-5.1, 0.5}, {-1, 0}, speed, 0.3);
  }
}

TEST(Contact, ASlantingBallKeepsFiveSeventhsAlongTheWall) {
  // A ball without spin at 45 degrees: friction of .35 times 1.3 of the normal speed is more than the 2/7 of
  // the slip that end it, so it leaves the wall rolling along it.
  Arena arena;
  arena.shoot({0, 3.6}, {3, 3});
  double before = 0;
  while (arena.ball().velocity.y() > 0) {
    before = arena.ball().velocity.x();
    arena.step();
  }
  EXPECT_NEAR(arena.ball().velocity.x(), before * 5 / 7, 0.0125);
}

TEST(Contact, GoalBackAbsorbsAndSidesRebound) {
  for (const double speed : {3.0, 5.0, 8.0}) {
    expect_restitution({4.56, 0}, {1, 0}, speed, 0.1);
    expect_restitution({4.6, 0.38}, {0, 1}, speed, 0.3);
    expect_restitution({4.6, -0.38}, {0, -1}, speed, 0.3);
  }
  Arena arena;
  arena.roll({4.3, 0}, {5, 0});
  arena.run(0.4);
  EXPECT_LT(arena.ball().position.x(), 4.5 + 0.18 - 0.0215 + 1e-3);
  EXPECT_GT(arena.ball().position.x(), 4.5);  // stays in the goal
}

TEST(Contact, APostReboundsStraightAndItsEdgeDeflects) {
  for (const double side : {-1.0, 1.0}) {
    Arena arena;
    arena.roll({4.3, side * 0.5225}, {4, 0});  // the middle of its front face
    const world::Vector3d straight = after_rebound(arena, 0);
    EXPECT_NEAR(straight.x(), -0.3 * 4, 0.025);
    EXPECT_LT(std::abs(straight.y()), 0.05);
    // 15 mm inside the edge: the normal there points 45 degrees inward, since 15 = 21.5 sin 44. The normal
    // speed is multiplied by -0.3, along the surface it stays but for friction (0.5, at most 2/7 of it).
    arena.shoot({4.47, side * 0.485}, {1, 0});
    arena.run(0.1);
    const Vector2d after = arena.ball().velocity.head<2>();
    EXPECT_GT(after.x(), 0);            // goes on into the goal
    EXPECT_LT(after.y() * side, -0.2);  // turned inward
    EXPECT_LT(after.norm(), 0.9);
  }
}

TEST(Contact, TheCrossbarStopsAChipFromBelowAndFromTheFront) {
  Arena front;
  front.place({4.4, 0, 0.168}, {3, 0, 0});  // falls 1.5 mm until it is there
  const world::Vector3d back = after_rebound(front, 0);
  EXPECT_NEAR(back.x(), -0.3 * 3, 0.03);
  front.run(1);
  EXPECT_LT(front.ball().position.x(), 4.5);

  Arena below;
  below.place({4.58, 0, 0.05}, {0, 0, 3});
  double rising = 0;
  while (below.ball().velocity.z() > 0) {
    rising = below.ball().velocity.z();
    below.step();
  }
  EXPECT_NEAR(below.ball().velocity.z(), -0.3 * rising, 2 * physics::gravity * world::substep_length);
  EXPECT_LT(below.ball().position.z(), 0.155 - 0.0215 + 1e-3);
}

TEST(Contact, AChipOverTheBarDoesNotEnterTheGoal) {
  // Over the goal line at 0.175 + 0.0215 m plus or minus 10 mm; under the bar it goes
  // in, over it it does not.
  for (const double height : {0.2065, 0.12}) {
    Arena arena;
    const double time = 0.2 / 3;
    arena.place({4.3, 0, height + physics::gravity * time * time / 2}, {3, 0, 0});
    bool inside = false;
    for (int i = 0; i < 480; ++i) {
      arena.step();
      const world::Vector3d& ball = arena.ball().position;
      inside = inside || (ball.x() > 4.53 && ball.x() < 4.68 && ball.z() < 0.155);
    }
    EXPECT_EQ(inside, height < 0.155) << height;
  }
}

// Two robots whose drives can do nothing, so that only the collision counts.
world::RobotSpecs powerless(double mass = 2.5) {
  world::RobotSpecs specs;
  specs.mass = mass;
  for (double* limit :
       {&specs.max_acceleration, &specs.max_acceleration_sideways, &specs.max_brake,
        &specs.max_brake_sideways, &specs.max_angular_acceleration, &specs.max_angular_brake}) {
    *limit = 1e-9;
  }
  return specs;
}

TEST(Contact, RobotsHeadOnKeepMomentumWithinTheRestitution) {
  // Momentum to single precision. The relative speed afterwards is 0.1 of the closing speed in the middle;
  // Bullet finds one corner of two flat fronts at a time, and an early contact loses its rebound (see above),
  // so it lies between 0 and 0.2 (a little below 0 where the hit turned them).
  for (const double other_mass : {2.5, 1.5}) {
    for (const double closing : {0.5, 2.0, 6.0}) {
      for (int phase = 0; phase < phases; ++phase) {
        std::vector<world::RobotSpecs> specs = {powerless(2.5), powerless(other_mass)};
        specs[0].id = {world::Team::Yellow, 1};
        specs[1].id = {world::Team::Blue, 1};
        physics::World world(world::Field{}, specs);
        world.put_robot(0, {-0.2 - closing * world::substep_length * phase / phases, 0}, 0);
        world.put_robot(1, {0.2, 0}, M_PI);  // front to front
        world.place_ball(Vector2d(0, 2));
        world.set_motion(0, {closing, 0}, 0);
        std::vector<truth::Contact> contacts;
        std::vector<truth::Kick> kicks;
        std::vector<truth::Robot> robots;
        const double time = 0.26 / closing + 0.1;  // they have met
        for (int i = 0; i < time / world::substep_length; ++i) {
          world.substep(world::tick_time(0, i), contacts, kicks);
        }
        world.read_robots(robots);
        const double momentum = 2.5 * robots[0].velocity.x() + other_mass * robots[1].velocity.x();
        EXPECT_NEAR(momentum, 2.5 * closing, 1e-5 * closing);
        const double parting = (robots[1].velocity.x() - robots[0].velocity.x()) / closing;
        EXPECT_GE(parting, -0.005) << closing << " phase " << phase;
        EXPECT_LE(parting, 0.2) << closing << " phase " << phase;
      }
    }
  }
}

TEST(Contact, AGlancingHitKeepsMomentumAndAddsNoEnergy) {
  for (int i = 0; i < 12; ++i) {
    Arena arena({{{-0.3, 0.015 * i}, 0.5 * i}, {{0, 0}, 1.1 * i}}, powerless());
    arena.world.set_motion(0, {2, 0}, 0);
    for (int k = 0; k < 120; ++k) arena.step();
    const truth::Robot a = arena.robot(0), b = arena.robot(1);
    EXPECT_LT((a.velocity + b.velocity - Vector2d(2, 0)).norm(), 1e-5) << i;
    const double inertia = 0.5 * 0.09 * 0.09;  // over mass
    const double energy =
        a.velocity.squaredNorm() + b.velocity.squaredNorm() +
        inertia * (a.angular_velocity * a.angular_velocity + b.angular_velocity * b.angular_velocity);
    EXPECT_LT(energy, 4 * (1 + 1e-5)) << i;
  }
}

TEST(Contact, ARobotStopsAtAWallAndAtAGoal) {
  // Restitution .05, what the products of one number per body give (.3 / .6 of .1): nearly dead.
  for (const Vector2d& from : {Vector2d(4.8, 2), Vector2d(4.2, 0.52)}) {
    for (const double speed : {1.0, 3.0}) {
      Arena arena({{from, 0}}, powerless());
      arena.world.set_motion(0, {speed, 0}, 0);
      arena.run(0.4 / speed + 0.1);
      EXPECT_LE(arena.robot(0).velocity.x(), 1e-3);
      EXPECT_GE(arena.robot(0).velocity.x(), -0.1 * speed);
    }
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
  // The apex of its flight is over the robot's centre, the ball's lowest point 4 mm above or below 150 mm;
  // over the robot's width it falls 2.5 mm.
  for (const bool over : {true, false}) {
    Arena arena({{{1, 0}, 0}});
    const double apex = 0.15 + 0.0215 + (over ? 0.004 : -0.004);
    const double time = 0.05;
    arena.place({1 - 4 * time, 0, apex - physics::gravity * time * time / 2},
                {4, 0, physics::gravity * time});
    arena.run(2 * time);
    EXPECT_EQ(arena.contacts.empty(), over);
    EXPECT_EQ(arena.ball().velocity.x() > 3.9, over);
  }
}

constexpr double on_cover = 0.15 + 0.0215;

TEST(Contact, ABallDroppedOnAStandingRobotComesToLieThere) {
  for (const double height : {0.18, 0.3, 0.6}) {
    Arena arena({{{0, 0}, 0.3}});
    arena.place({0.02, -0.01, height});
    arena.run(4);
    EXPECT_NEAR(arena.ball().position.z(), on_cover, 5e-4) << height;  // Bullet leaves some overlap
    EXPECT_LT((arena.ball().position.head<2>() - Vector2d(0.02, -0.01)).norm(), 1e-3) << height;
    EXPECT_LT(arena.ball().velocity.norm(), 1e-6) << height;
    EXPECT_EQ(arena.contacts.back().robot, arena.specs[0].id);
  }
}

TEST(Contact, ABallOnARobotRidesGentlyAndRollsOffAHastyOne) {
  // A sphere on a plate that accelerates by a lags by 5/7 a, against which rolling resistance has .3 m/s^2:
  // it rides up to .42 m/s^2.
  for (const double acceleration : {0.3, 0.6, 3.0}) {
    world::RobotSpecs specs;
    specs.max_acceleration = acceleration;
    Arena arena({{{-4, 0}, 0}}, specs);
    arena.place({-4, 0, on_cover});
    arena.run(0.3);
    world::RobotCommand command;
    command.velocity_local = {0.6, 0};
    arena.world.set_command(0, command);
    const double time = 0.6;  // lags by (5/7 a - 0.3) t^2 / 2: 23 mm at 0.6, beyond the cover at 3
    arena.run(time);
    const double behind = arena.robot(0).position.x() - arena.ball().position.x();
    if (acceleration < 0.42) {
      EXPECT_LT(behind, 2e-3);
    } else if (acceleration < 1) {
      EXPECT_NEAR(behind, (5.0 / 7 * acceleration - 0.3) * time * time / 2, 2e-3);
    }
    arena.run(2);
    EXPECT_EQ(arena.ball().position.z() > 0.1, acceleration < 0.42) << acceleration;
  }
}

TEST(Contact, ABallRollingOverARobotFallsOffItsFarSide) {
  Arena arena({{{0, 0}, 0}});
  truth::Ball ball;
  ball.position = {-0.08, 0, on_cover};
  ball.velocity = {0.5, 0, 0};
  ball.spin = {0, 0.5 / 0.0215, 0};
  arena.world.place_ball(ball);
  arena.run(1.5);
  EXPECT_LT(arena.ball().position.z(), 0.05);
  EXPECT_GT(arena.ball().position.x(), 0.09);
}

TEST(Contact, NoBallStaysOnAGoal) {
  for (const double x : {4.51, 4.58, 4.67, 4.70, 4.735}) {
    for (const double y : {0.0, 0.3, 0.49, 0.52}) {
      for (const double sign : {-1.0, 1.0}) {
        Arena arena;
        arena.place({sign * x, y, 0.3});
        arena.run(2.5);
        EXPECT_LT(arena.ball().position.z(), 0.1) << x << " " << y;
        EXPECT_FALSE(std::abs(arena.ball().position.x()) < 4.68 && std::abs(arena.ball().position.y()) < 0.5)
            << "fell through the roof";
      }
    }
  }
}

TEST(Contact, ABallWedgedBetweenARobotAndAGoalGetsFreeWhenTheRobotLeaves) {
  Arena arena({{{4.5 - 0.09 - 0.01, 0.52}, M_PI}});  // beside the post, as high as the roof but for 25 mm
  arena.place({4.47, 0.52, 0.25});
  arena.run(2);
  world::RobotCommand command;
  command.velocity_local = {1, 0};
  arena.world.set_command(0, command);
  arena.run(2);
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
