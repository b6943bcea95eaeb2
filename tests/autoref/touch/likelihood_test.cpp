#include "autoref/touch/likelihood.h"

#include <gtest/gtest.h>

#include <functional>

namespace touch {
namespace {

constexpr LikelihoodParams params;
constexpr double noise = 0.0005;  // [m]

/// Six sightings, the newest at t = 0, a tick apart.
View sighted(const std::function<Vector2d(double seconds)>& ball) {
  View view;
  for (int n = 5; n >= 0; --n) view.push(world::tick_time(100 - n), ball(-n * world::tick_length));
  return view;
}

/// Comes along x, and at `when` at the origin turns to `after`.
View broken_course(const Vector2d& before, const Vector2d& after, double when) {
  return sighted([=](double t) -> Vector2d { return (t - when) * (t < when ? before : after); });
}

TEST(HullGap, KnowsTheCircleAndTheFlatFront) {
  const world::Field field;
  EXPECT_NEAR(hull_gap({-0.1115, 0}, field), 0, 1e-12);         // behind: R + r
  EXPECT_NEAR(hull_gap({0, 0.1215}, field), 0.01, 1e-12);       // beside
  EXPECT_NEAR(hull_gap({0.073 + 0.0215, 0}, field), 0, 1e-12);  // at the plate, 73 mm before the centre
  EXPECT_NEAR(hull_gap({0.0945, 0.03}, field), 0, 1e-12);       // and all along it
}

TEST(Fit, FindsTheBreakExactly) {
  // Any moment between d3 and d2, which are 3 and 2 ticks old: two straight lines have one common point.
  for (const double share : {0.0, 0.3, 0.9}) {
    const double when = (-3 + share) * world::tick_length;
    const Broken broken = fit(broken_course({3, 0}, {-0.5, 1}, when), noise);
    // Times are whole nanoseconds, 3e-8 of a tick at most away from it.
    EXPECT_LT((broken.before - Vector2d(3, 0)).norm(), 2e-7);
    EXPECT_LT((broken.after - Vector2d(-0.5, 1)).norm(), 2e-7);
    EXPECT_NEAR(broken.share, share, 1e-6);
    EXPECT_LT(broken.place.norm(), 1e-8);
    EXPECT_LT(broken.misfit, 1e-8);
  }
}

TEST(Fit, SigmaIsThatOfTwoSlopes) {
  // A slope through three samples T apart has the variance s^2 / (2 T^2); two of them add.
  const Broken broken = fit(broken_course({1, 0}, {1, 0}, -0.04), noise);
  EXPECT_NEAR(broken.sigma, noise / world::tick_length, 1e-6);  // times of a tick are whole nanoseconds
}

/// The odds of a touch by a robot at `gap` whose hull the ball leaves along `normal`.
double odds(const View& view, double gap, const Vector2d& normal, const Vector2d& robot_velocity = {0, 0}) {
  const Broken broken = fit(view, noise);
  const double free = free_density(broken, 0, false, params);
  return contact_density(broken, {gap, normal, robot_velocity, false}, noise, free, params) / free;
}

TEST(Likelihood, ABounceSpeaksForContact) {
  const View bounce = broken_course({3, 0}, {-1.5, 0}, -0.04);
  EXPECT_GT(odds(bounce, 0, {-1, 0}), 100);
  EXPECT_LT(odds(bounce, 0.05, {-1, 0}),
            odds(bounce, 0, {-1, 0}) / 100);  // rather than by a robot 50 mm away
}

TEST(Likelihood, APushPointsAwayFromTheRobot) {
  // The ball is turned to +y: a robot on its -y side did it, not one on its +y side.
  const View turned = broken_course({3, 0}, {3, 0.8}, -0.04);
  EXPECT_GT(odds(turned, 0, {0, 1}), 3 * odds(turned, 0, {0, -1}));
}

TEST(Likelihood, ABallThatRollsPastIsFree) {
  const auto rolling = [](double t) { return Vector2d(2 * t - 0.13 * t * t, 0); };  // 0.26 m/s^2
  EXPECT_LT(odds(sighted(rolling), 0.005, {0, 1}), 0.1);
  const auto sliding = [](double t) { return Vector2d(5 * t - 1.5 * t * t, 0); };  // 3 m/s^2
  EXPECT_LT(odds(sighted(sliding), 0.005, {0, 1}), 0.1);
}

TEST(Likelihood, ABallThatMovesAlongWithTheRobotIsItsOwn) {
  const auto carried = [](double t) { return Vector2d(1 * t, 0); };
  EXPECT_GT(odds(sighted(carried), 0, {1, 0}, {1, 0}), 1);
  EXPECT_LT(odds(sighted(carried), 0, {0, 1}, {0, 0}), 1);  // the same ball passing a robot that stands
}

TEST(Likelihood, ABallInTheAirMayBendFreely) {
  const Broken bent = fit(broken_course({3, 0}, {2.75, 0.1}, -0.04), noise);
  EXPECT_GT(free_density(bent, 1, false, params), 20 * free_density(bent, 0, false, params));
}

TEST(Passage, IsFreeOnlyAlongItsOwnCourse) {
  Course before;
  before.velocity = {2, 0};
  before.spread = 5 * world::tick_length * world::tick_length;  // four samples a tick apart
  Course after = before;
  after.time = before.time + std::chrono::milliseconds{200};
  after.middle = {0.4 - 0.005, 0};
  after.velocity = {1.95, 0};
  EXPECT_GT(passed_freely(before, after, noise, params), 10 * passage_changed(before, after, params));
  after.velocity = {1.9, 0.2};  // a tenth of its direction
  EXPECT_LT(passed_freely(before, after, noise, params), passage_changed(before, after, params));
  after.velocity = {1.95, 0};
  after.middle = {0.395, 0.05};  // along, but from another line
  EXPECT_LT(passed_freely(before, after, noise, params), passage_changed(before, after, params));
}

}  // namespace
}  // namespace touch
