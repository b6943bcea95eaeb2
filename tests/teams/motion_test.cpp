#include "teams/skills/motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace skills {
namespace {

const Limits limits{3, 3, 6};

TEST(Profile, FromRestOverAShortWayIsATriangle) {
  // Speeds up at 3, brakes at 6: v^2 = 2 a b d / (a + b) = 4 for d = 1, so v = 2; t = 2/3 + 2/6 = 1 s.
  const Profile profile(1, 0, limits);
  EXPECT_NEAR(profile.duration(), 1.0, 1e-12);
  EXPECT_NEAR(profile.velocity(2.0 / 3), 2.0, 1e-12);
}

TEST(Profile, FromRestOverALongWayCruises) {
  // 9/6 = 1.5 m to reach 3 m/s in 1 s, 9/12 = 0.75 m and 0.5 s to brake, 3.75 m at 3 m/s for 1.25 s.
  EXPECT_NEAR(Profile(6, 0, limits).duration(), 2.75, 1e-12);
}

TEST(Profile, TooFastToStopInTimeComesBack) {
  // From 3 m/s braking takes 0.75 m and 0.5 s; 0.5 m back from rest: v^2 = 2, t = 1.41421/3 + 1.41421/6.
  EXPECT_NEAR(Profile(0.25, 3, limits).duration(), 0.5 + std::sqrt(2.0) * 0.5, 1e-12);
}

TEST(Profile, MovingAwayTurnsRound) {
  // Brakes 1 m/s in 1/6 s and 1/12 m, then 1 + 1/12 m from rest.
  const double rest = std::sqrt(2 * 3 * 6 * (1 + 1.0 / 12) / 9);
  EXPECT_NEAR(Profile(1, -1, limits).duration(), 1.0 / 6 + rest / 3 + rest / 6, 1e-12);
}

TEST(Profile, FasterThanAllowedBrakesToTheLimitFirst) {
  const Profile profile(6, 4, limits);
  EXPECT_NEAR(profile.velocity(1.0 / 6), 3.0, 1e-12);
  EXPECT_NEAR(profile.position(profile.duration()), 6, 1e-12);
}

TEST(Profile, EndsAtTheTargetAtRestFromAnywhere) {
  std::mt19937_64 dice(1);
  std::uniform_real_distribution<double> distance(-8, 8), speed(-4, 4);
  for (int i = 0; i < 2000; ++i) {
    const double d = distance(dice), v = speed(dice);
    const Profile profile(d, v, limits);
    // 1e-9: some tens of roundings of numbers around 10.
    EXPECT_NEAR(profile.position(profile.duration()), d, 1e-9) << d << " " << v;
    EXPECT_NEAR(profile.velocity(profile.duration()), 0, 1e-9) << d << " " << v;
    EXPECT_NEAR(profile.duration(), time_to_rest(d, v, limits), 1e-9) << d << " " << v;
  }
}

TEST(Profile, MirroredStartsTakeTheSameTime) {
  EXPECT_DOUBLE_EQ(Profile(2.5, 1.2, limits).duration(), Profile(-2.5, -1.2, limits).duration());
}

TEST(Drive, ArrivesWithBothAxesTogether) {
  std::mt19937_64 dice(2);
  std::uniform_real_distribution<double> place(-4, 4), speed(-2, 2);
  for (int i = 0; i < 500; ++i) {
    const Vector2d to(place(dice), place(dice)), velocity(speed(dice), speed(dice));
    const Drive drive(to, velocity, limits);
    const double end = drive.duration();
    EXPECT_LT((drive.position(end) - to).norm(), 1e-9);
    EXPECT_LT(drive.velocity(end).norm(), 1e-9);
    EXPECT_LT((drive.velocity(0) - velocity).norm(), 1e-12);
  }
}

TEST(Drive, IsTheSameWithEveryGuess) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> way(-5, 5), speed(-3.5, 3.5);
  for (int i = 0; i < 300; ++i) {
    const Vector2d to(way(engine), way(engine)), velocity(speed(engine), speed(engine));
    const Drive wanted(to, velocity, limits);
    for (int guess = -1; guess <= 64; ++guess) {
      int cell = guess;
      const Drive drive(to, velocity, limits, &cell);
      EXPECT_EQ(drive.velocity(0.02), wanted.velocity(0.02)) << guess;
      EXPECT_EQ(drive.duration(), wanted.duration()) << guess;
    }
  }
}

TEST(Drive, FromRestGoesStraightInTheTimeOfOneAxis) {
  const Drive drive({3, 4}, {0, 0}, limits);
  // 2 %: the axis across keeps a share of 0.02 of the limits, the axis along has them all.
  EXPECT_NEAR(drive.duration(), time_to_rest(5, 0, limits), 0.02);
  const Vector2d half = drive.position(drive.duration() / 2);
  EXPECT_NEAR(half.x() * 4 - half.y() * 3, 0, 1e-9);
}

TEST(Drive, NeverAsksForMoreThanTheLimits) {
  const Drive drive({2, 1}, {-1, 2}, limits);
  const double dt = 1.0 / 240;
  for (double t = 0; t < drive.duration(); t += dt) {
    EXPECT_LE(drive.velocity(t).norm(), limits.speed + 1e-9);
    // Braking may use both axes' brakes at once: the limit of the whole is the brake's.
    EXPECT_LE((drive.velocity(t + dt) - drive.velocity(t)).norm() / dt, limits.brake + 1e-6);
  }
}

TEST(TravelTime, IsThatOfTheProfileWhenDrivingAtTheTarget) {
  EXPECT_NEAR(travel_time({2, 0}, {1, 0}, limits), time_to_rest(2, 1, limits), 1e-12);
}

TEST(TimeToTouch, PassesThePointAtFullSpeed) {
  // 1.5 m to reach 3 m/s in 1 s, then 1.5 m in 0.5 s.
  EXPECT_NEAR(time_to_touch({3.1, 0}, {0, 0}, limits, 0.1), 1.5, 1e-12);
  EXPECT_EQ(time_to_touch({0.1, 0}, {0, 0}, limits, 0.2), 0);
}

TEST(Limits, AreThoseOfASlowRobot) {
  const world::RobotSpecs slow = world::slowed({}, 0.5);
  EXPECT_EQ(driving_limits(slow).speed, 1.5);
  EXPECT_NEAR(driving_limits(slow).acceleration, 0.95 * 1.5, 1e-12);
}

}  // namespace
}  // namespace skills
