#include "sim/server/wheels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/random.h"

namespace {

constexpr double radius = 0.09;  // [m]

/// The other direction, straight from the geometry: the rim's direction is the tangent at the wheel.
double rim_speed(double angle, const server::LocalMotion& motion) {
  const world::Vector2d place = radius * world::direction(-angle);  // clockwise from forward
  const world::Vector2d velocity =
      motion.velocity + motion.angular_velocity * world::Vector2d(-place.y(), place.x());
  const world::Vector2d tangent(-place.y() / radius, place.x() / radius);  // counter-clockwise
  return velocity.dot(tangent);
}

}  // namespace

TEST(Wheels, InvertTheGeometryForAnyAngles) {
  world::RandomStream random(7, "wheels");
  for (int i = 0; i < 1000; ++i) {
    // Each wheel within 35 degrees of the middle of its quarter, as on any robot of the league.
    const auto angle = [&](int quarter) {
      return (quarter + 0.5) * M_PI / 2 + (random.uniform() - 0.5) * 70 * M_PI / 180;
    };
    const wire::WheelAngles angles = {angle(0), angle(1), angle(2), angle(3)};
    const server::LocalMotion wanted = {{6 * random.uniform() - 3, 6 * random.uniform() - 3},
                                        20 * random.uniform() - 10};
    const wire::WheelSpeeds speeds = {
        rim_speed(angles.front_right, wanted), rim_speed(angles.back_right, wanted),
        rim_speed(angles.back_left, wanted), rim_speed(angles.front_left, wanted)};
    const auto found = server::motion(angles, speeds, radius);
    ASSERT_TRUE(found);
    // Double arithmetic; the angles may be badly spread by chance, which costs up to four digits.
    EXPECT_NEAR((found->velocity - wanted.velocity).norm(), 0, 1e-11);
    EXPECT_NEAR(found->angular_velocity, wanted.angular_velocity, 1e-9);
  }
}

TEST(Wheels, DisagreeingOnesSlipEqually) {
  // With the standard angles the four rims of no motion at all are (1, -1, 1, -1): pure slip.
  const auto found = server::motion({}, {1, -1, 1, -1}, radius);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->velocity.norm(), 0, 1e-12);
  EXPECT_NEAR(found->angular_velocity, 0, 1e-12);
}

TEST(Wheels, ThatAllPushOneWaySayNothing) {
  EXPECT_FALSE(server::motion({1, 1, 1, 1}, {}, radius));
  EXPECT_FALSE(server::motion({0, M_PI, 0, M_PI}, {}, radius)) << "forward and back is left open";
  EXPECT_TRUE(server::motion({}, {}, radius));
}
