#include "sim/physics/ball.h"

#include <gtest/gtest.h>

#include "tests/sim/physics/arena.h"

namespace {

using physics::BallParams;
using world::Vector2d;

// Positions are floats of up to 5 m: each of some 1000 substeps rounds by at most 0.24 um.
constexpr double rounding = 3e-4;  // [m]

truth::Ball flying(double x, double z, double vx, double vz) {
  truth::Ball ball;
  ball.position = {x, 0, z};
  ball.velocity = {vx, 0, vz};
  return ball;
}

TEST(Ball, RollsTheDistanceOfItsDeceleration) {
  Arena arena;
  arena.roll({-2, 0}, {1, 0});
  arena.run(5);
  EXPECT_NEAR(arena.ball().position.x(), -2 + 1 / (2 * 0.26), rounding);
  EXPECT_EQ(arena.ball().velocity.norm(), 0);
  EXPECT_EQ(arena.ball().spin.norm(), 0);
}

TEST(Ball, SlidesToFiveSeventhsOfTheKickThenRolls) {
  Arena arena;
  arena.shoot({-4, 0}, {3, 0});
  const double slide_time = 3 * 2.0 / 7 / 3.0;  // (1 - 5/7) v / a
  arena.run(slide_time + 0.001);
  const double rolled = arena.time() - slide_time;
  EXPECT_NEAR(arena.ball().velocity.x(), 3 * 5.0 / 7 - 0.26 * rolled, 1e-5);
  EXPECT_NEAR(arena.ball().spin.y() * arena.field.ball_radius, arena.ball().velocity.x(), 1e-5);
}

TEST(Ball, StopsAtTheClosedFormDistanceOfASlidingKick) {
  Arena arena;
  arena.shoot({-4.2, 0.7}, {1.9, 0});
  const double expected = physics::rolling_distance(1.9, BallParams{});
  arena.run(10);
  // The substep in which sliding ends moves with its mean velocity: less than a_s h^2 off.
  EXPECT_NEAR(arena.ball().position.x(), -4.2 + expected,
              rounding + 3.0 * std::pow(world::substep_length, 2));
  EXPECT_NEAR(arena.ball().position.y(), 0.7, rounding);
}

TEST(Ball, FrictionDoesNotDependOnHowADurationIsSplit) {
  truth::Ball once = flying(0, 0.0215, 2, 0);
  once.velocity.y() = -0.7;
  once.spin = {10, -30, 5};
  truth::Ball often = once;
  physics::apply_ground_friction(once, 0.9, BallParams{});
  for (int i = 0; i < 900; ++i) physics::apply_ground_friction(often, 0.001, BallParams{});
  EXPECT_TRUE(once.velocity.isApprox(often.velocity, 1e-9));  // both are exact but for rounding
  EXPECT_TRUE(once.spin.isApprox(often.spin, 1e-9));
}

TEST(Ball, BackspinCanTurnItRound) {
  truth::Ball ball = flying(0, 0.0215, 0.5, 0);
  ball.spin.y() = -200;
  physics::apply_ground_friction(ball, 2, BallParams{});
  EXPECT_LT(ball.velocity.x(), 0);
}

TEST(Ball, ChipReachesApexAndCarryOfAParabola) {
  Arena arena;
  const double v = 5 / std::sqrt(2.0);
  arena.world.place_ball(flying(-3, arena.field.ball_radius, v, v));
  double apex = 0;
  double carry = 0;
  while (carry == 0) {
    const double falling = arena.ball().velocity.z();
    arena.step();
    apex = std::max(apex, arena.ball().position.z());
    if (falling < 0 && arena.ball().velocity.z() > 0) carry = arena.ball().position.x() + 3;
  }
  EXPECT_NEAR(apex - arena.field.ball_radius, v * v / (2 * physics::gravity),
              1e-4);  // sampled within 2 ms of it
  // Known to the substep of the bounce, in which it goes at least 5/7 as fast.
  EXPECT_NEAR(carry, 2 * v * v / physics::gravity, v * world::substep_length);
}

TEST(Ball, EveryHopReachesTheSquareOfTheRestitutionOfTheOneBefore) {
  for (const double height : {0.3, 0.5, 1.1, 2.0}) {
    Arena arena;
    arena.world.place_ball(flying(0, arena.field.ball_radius + height, 0, 0));
    double previous = 0;
    std::vector<double> apexes;
    for (int i = 0; i < 700; ++i) {
      arena.step();
      if (previous > 0 && arena.ball().velocity.z() <= 0) {
        apexes.push_back(arena.ball().position.z() - arena.field.ball_radius);
      }
      previous = arena.ball().velocity.z();
    }
    // Hops of e^2 = 1/4 of the one before, until one would be under 10 mm.
    std::size_t hops = 0;
    for (double expected = height / 4; expected > 0.010; expected /= 4, ++hops) {
      ASSERT_GT(apexes.size(), hops) << height;
      // A sample is at most half a substep from the apex: g (h/2)^2 / 2 = 21 um below it; floats add some.
      EXPECT_NEAR(apexes[hops], expected, 1e-4) << height << " hop " << hops;
    }
    EXPECT_EQ(apexes.size(), hops);
    EXPECT_EQ(arena.ball().velocity.z(), 0);
    EXPECT_EQ(arena.ball().position.z(), arena.field.ball_radius);
  }
}

TEST(Ball, AChipGoesItsHopsInClosedForm) {
  // 5 m/s at 45 degrees. The first bounce ends all slip (5/7 along the carpet) and the ball rolls from then
  // on; vertically each hop has half the speed. Where it first rolls is the sum of the carries.
  Arena arena;
  const double v = 5 / std::sqrt(2.0);
  arena.world.place_ball(flying(-4, arena.field.ball_radius, v, v));
  double expected = 2 * v * v / physics::gravity;
  double rise = v / 2;
  while (rise * rise > 2 * physics::gravity * 0.010) {
    expected += 2 * rise / physics::gravity * v * 5 / 7;
    rise /= 2;
  }
  while (!physics::on_ground(arena.ball(), physics::BallParams{})) arena.step();
  // Each bounce and the end are known to a substep of at most 3.5 m/s.
  EXPECT_NEAR(arena.ball().position.x(), -4 + expected, v * world::substep_length);
  EXPECT_NEAR(arena.ball().velocity.x(), v * 5 / 7, 0.26 * world::substep_length + 1e-4);
  EXPECT_NEAR(arena.ball().spin.y() * arena.field.ball_radius, arena.ball().velocity.x(), 1e-4);
}

TEST(Ball, SlideToRollHoldsAtEverySpeed) {
  for (const double speed : {0.5, 1.0, 2.0, 4.0, 6.5, 8.0}) {
    truth::Ball ball = flying(0, 0.0215, speed, 0);
    physics::apply_ground_friction(ball, speed * 2 / 7 / 3.0, BallParams{});
    EXPECT_NEAR(ball.velocity.x() / speed, 5.0 / 7, 1e-12);  // published fits: .64 to .714
    EXPECT_NEAR(ball.spin.y() * 0.0215, ball.velocity.x(), 1e-12);
  }
}

TEST(Ball, BackspinShortensASlideByTheClosedForm) {
  // v and surface speed s backwards: slip v + s shrinks at 7/2 a_s; rolling speed (5 v - 2 s) / 7.
  for (const double s : {0.5, 1.05}) {
    for (const double v : {0.0, 0.3, 2.0, 6.0}) {
      truth::Ball ball = flying(0, 0.0215, v, 0);
      ball.spin.y() = -s / 0.0215;
      physics::apply_ground_friction(ball, (v + s) / (3.5 * 3.0), BallParams{});
      EXPECT_NEAR(ball.velocity.x(), (5 * v - 2 * s) / 7, 1e-12);
      EXPECT_NEAR(ball.spin.y() * 0.0215, ball.velocity.x(), 1e-12);
    }
  }
}

TEST(Ball, ObliqueBounceEndsTheSlipAtFiveSevenths) {
  truth::Ball ball = flying(0, 0.02, 3, -3);
  physics::bounce(ball, BallParams{});
  EXPECT_NEAR(ball.velocity.x(), 3 * 5.0 / 7, 1e-12);  // friction suffices: .35 * 1.5 > 2/7
  EXPECT_NEAR(ball.spin.y() * 0.0215, ball.velocity.x(), 1e-12);
}

TEST(Ball, FlatBounceIsLimitedByFriction) {
  truth::Ball ball = flying(0, 0.0215 - 1e-9, 8, -1);
  physics::bounce(ball, BallParams{});
  EXPECT_NEAR(ball.velocity.x(), 8 - 0.35 * 1.5 * 1, 1e-6);
}

}  // namespace
