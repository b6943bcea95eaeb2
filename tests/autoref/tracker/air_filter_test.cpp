#include "autoref/tracker/air_filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/world/random.h"

namespace tracker {
namespace {

constexpr double g = 9.81;
const Vector3d camera(-2.25, -1.5, 4);

Vector2d projected(const Vector3d& ball, const Vector3d& eye) {
  return eye.head<2>() + (ball - eye).head<2>() * (eye.z() / (eye.z() - ball.z()));
}

struct Chip {
  Vector2d from = Vector2d(-3, -2);
  Vector3d launch = Vector3d(2.8, 2.0, 3.4);
  Vector3d at(double t) const {
    return {from.x() + launch.x() * t, from.y() + launch.y() * t, launch.z() * t - g / 2 * t * t};
  }
};

TEST(AirFilter, FindsAFlightFromExactPlacesOnTheGround) {
  const Chip chip;
  AirFilter filter(chip.from, 1e-4);
  for (int n = 1; n <= 30; ++n) {
    filter.predict(1.0 / 60);
    const AirFilter::Fit fit = filter.update(projected(chip.at(n / 60.0), camera), camera, 1e-10);
    if (n > 6) {
      EXPECT_LT(fit.nis, 1.0) << n;
    }
  }
  // 30 frames of 10 um noise; the model's own noise of 0.15 m/s^2 lets the height err by a few mm.
  EXPECT_LT((filter.position() - chip.at(0.5)).norm(), 0.002);
  EXPECT_LT((filter.velocity() - Vector3d(2.8, 2.0, 3.4 - g / 2)).norm(), 0.02);
  EXPECT_LT((filter.seen_from(camera) - projected(chip.at(0.5), camera)).norm(), 1e-4);
}

TEST(AirFilter, IsHonestAboutNoise) {
  // Noise as the filter assumes, kick point wrong by its sigma: mean square 1 per
  // number, errors as sigma says.
  world::RandomStream noise(3, "air");
  double sum = 0, normalised = 0;
  int count = 0, flights = 0;
  for (int k = 0; k < 300; ++k) {
    Chip chip;
    chip.from += 0.01 * Vector2d(noise.gaussian(), noise.gaussian());
    AirFilter filter(Vector2d(-3, -2), 0.01);
    for (int n = 1; n <= 24; ++n) {
      filter.predict(1.0 / 60);
      const Vector2d seen = projected(chip.at(n / 60.0), camera);
      const auto fit =
          filter.update(seen + 0.001 * Vector2d(noise.gaussian(), noise.gaussian()), camera, 1e-6);
      if (n > 4) sum += fit.nis, count += 2;
    }
    normalised +=
        (filter.position() - chip.at(0.4)).head<2>().squaredNorm() / (filter.sigma() * filter.sigma());
    ++flights;
  }
  EXPECT_NEAR(sum / count, 0.95, 0.1);  // 12000 numbers: 1.3 %; the model's own noise makes it expect more
  // `sigma` is of the larger axis and holds the model's own noise, which these flights have not: the sum over
  // both axes is below 2, and not so far that sigma would say nothing.
  EXPECT_GT(normalised / flights, 0.4);
  EXPECT_LT(normalised / flights, 2.2);
}

TEST(AirFilter, BouncesWhereItComesDown) {
  const Chip chip;
  AirFilter filter(chip.from, 1e-4);
  for (int n = 1; n <= 30; ++n) {
    filter.predict(1.0 / 60);
    filter.update(projected(chip.at(n / 60.0), camera), camera, 1e-10);
  }
  const double flight = 2 * 3.4 / g;
  filter.predict(flight - 0.5 - 0.001);
  EXPECT_EQ(filter.bounces(), 0);
  filter.predict(0.05);
  EXPECT_EQ(filter.bounces(), 1);
  // Restitution 0.5 and 5/7 of the horizontal speed (football.md 5); 49 ms later.
  EXPECT_NEAR(filter.velocity().z(), 1.7 - g * 0.049, 0.05);
  EXPECT_NEAR(filter.velocity().x(), 2.8 * 5 / 7, 0.03);
  EXPECT_FALSE(filter.rolls());
  filter.predict(1.0);  // hops of 0.35, 0.17 s, then 9 mm high ones, which are rolling
  EXPECT_TRUE(filter.rolls());
  EXPECT_EQ(filter.position().z(), 0);
  EXPECT_EQ(filter.velocity().z(), 0);
}

// The cover of a robot is flat: what comes down on it bounces as on the ground, 0.15 m higher.
TEST(AirFilter, BouncesOnARobotAndThenOnTheGround) {
  AirFilter filter(Vector3d(0, 0, 0.3), 1e-4);
  filter.predict(0.18);  // 0.159 m deep at 1.77 m/s: 9 mm below the cover
  filter.bounce_on(0.15);
  EXPECT_NEAR(filter.position().z(), 0.15 + 0.5 * 0.009, 1e-4);
  EXPECT_NEAR(filter.velocity().z(), 0.5 * g * 0.18, 1e-9);
  EXPECT_FALSE(filter.rolls());
  filter.predict(0.35);  // up for 0.09 s, down from 0.194 m for 0.2 s
  EXPECT_EQ(filter.bounces(), 2);
}

// What strikes a ball in the air changes its way along the ground; the height stays.
TEST(AirFilter, AStrikeLeavesThePlaceAndForgetsTheWay) {
  const Chip chip;
  AirFilter filter(chip.from, 1e-4);
  for (int n = 1; n <= 10; ++n) {
    filter.predict(1.0 / 60);
    filter.update(projected(chip.at(n / 60.0), camera), camera, 1e-10);
  }
  filter.strike();
  const Vector3d place = chip.at(10 / 60.0);
  const Vector3d after(-1.5, 0.5, 3.4 - g * 10 / 60.0);
  for (int n = 1; n <= 6; ++n) {
    const double t = n / 60.0;
    filter.predict(1.0 / 60);
    const Vector3d ball = place + after * t - Vector3d(0, 0, g / 2 * t * t);
    filter.update(projected(ball, camera), camera, 1e-10);
  }
  // Six places of 10 um noise and the old height, known to a few mm.
  EXPECT_NEAR(filter.velocity().x(), -1.5, 0.1);
  EXPECT_NEAR(filter.position().z(), place.z() + after.z() * 0.1 - g / 2 * 0.01, 0.02);
}

TEST(AirFilter, OneStepOrManyIsTheSame) {
  AirFilter one(Vector2d(1, 1), 0.01);
  AirFilter many(Vector2d(1, 1), 0.01);
  one.predict(0.3);
  for (int n = 0; n < 30; ++n) many.predict(0.01);
  EXPECT_LT((one.position() - many.position()).norm(), 1e-12);  // rounding
  EXPECT_LT((one.velocity() - many.velocity()).norm(), 1e-12);
  EXPECT_NEAR(one.sigma(), many.sigma(), 1e-12);
}

}  // namespace
}  // namespace tracker
