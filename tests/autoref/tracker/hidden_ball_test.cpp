#include "autoref/tracker/hidden_ball.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/vision/occlusion.h"
#include "tests/autoref/tracker/running.h"

namespace tracker {
namespace {

using namespace std::chrono_literals;

constexpr RobotId blue_2{Team::Blue, 2};

world::Geometry with_cameras() {
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  return geometry;
}

// The camera at (-2.25, -1.5) looks along this at what happens near (-1, -1).
const Vector2d foot(-2.25, -1.5);
const Vector2d away = (Vector2d(-1, -1) - foot).normalized();
constexpr double held = 0.0945;  // [m] from a robot's centre to a ball at its front

world::TrackedRobot robot_at(RobotId id, const Vector2d& position, const Vector2d& facing) {
  return {.id = id, .position = position, .orientation = world::angle_of(facing)};
}

world::Time frame(int n) { return world::Time{n * 16667us}; }

TEST(HiddenBall, IsWithTheRobotThatHidesItAndNotWithTheOneThatWouldShowIt) {
  // Two fronts press one ball; blue stands on the camera's side and hides it. When they part the ball went
  // with one of them. At yellow's front it would be in view.
  const Vector2d ball = Vector2d(-1, -1) + held * away;
  std::vector<world::TrackedRobot> robots = {robot_at(yellow_3, ball + held * away, -away),
                                             robot_at(blue_2, {-1, -1}, away)};
  HiddenBall hidden(with_cameras());
  hidden.start({ball, Vector2d::Zero()}, frame(0), robots);
  for (int n = 1; n <= 60; ++n) {
    robots[0].position += 0.01 * away;
    robots[0].velocity = 0.6 * away;
    hidden.advance(frame(n), robots);
  }
  EXPECT_LT((hidden.best(frame(60), robots).position - ball).norm(), 0.005);  // the fronts' reach is 10 mm
}

TEST(HiddenBall, IsWithTheOtherRobotWhenTheOneThatSeemedToHaveItTurnsAndShowsNone) {
  // The same, but blue turns to the camera: at its front there is no ball. It is where it was, at yellow's
  // front and behind blue's back.
  const Vector2d ball = Vector2d(-1, -1) + held * away;
  for (const double turn : {0.05, -0.05}) {
    std::vector<world::TrackedRobot> robots = {robot_at(yellow_3, ball + held * away, -away),
                                               robot_at(blue_2, {-1, -1}, away)};
    HiddenBall hidden(with_cameras());
    hidden.start({ball, Vector2d::Zero()}, frame(0), robots);
    for (int n = 1; n <= 63; ++n) {
      robots[1].orientation = world::wrap_angle(robots[1].orientation + turn);
      robots[1].angular_velocity = 60 * turn;
      hidden.advance(frame(n), robots);
    }
    // Blue's back reaches 17 mm farther than its front and pushes the ball aside;
    // blue's front is 0.19 m away.
    EXPECT_LT((hidden.best(frame(63), robots).position - ball).norm(), 0.07) << turn;
  }
}

TEST(HiddenBall, IsWithARobotThatWasNearWhenItsOwnWayIsInViewAndEmpty) {
  // It is lost at 2 m/s on its way past blue, whose front hides what it has caught. After a few frames its
  // free way leads to where the camera would see it.
  const std::vector<world::TrackedRobot> robots = {robot_at(blue_2, {-1, -1}, away)};
  const Vector2d side(-away.y(), away.x());
  const Vector2d lost = robots[0].position + 0.12 * away - 0.06 * side;
  HiddenBall hidden(with_cameras());
  hidden.start({lost, 2 * side}, frame(0), robots);
  for (int n = 1; n <= 20; ++n) hidden.advance(frame(n), robots);
  EXPECT_LT((hidden.best(frame(20), robots).position - robots[0].position).norm(), 0.12);
}

TEST(HiddenBall, IsOutsideAsFarAsItsHypothesesAre) {
  // Blue holds it on the touch line, its front towards the camera's blind side:
  // one hypothesis, known to 15 mm.
  const world::Field field;
  for (const double beyond : {-0.015, 0.0, 0.015}) {
    const double y = -field.half_width() - field.ball_radius - beyond;
    const Vector2d ball(-1, y);
    const std::vector<world::TrackedRobot> robots = {
        robot_at(blue_2, ball + Vector2d(0, held), Vector2d(0, -1))};
    HiddenBall hidden(with_cameras());
    hidden.start({ball, Vector2d::Zero()}, frame(0), robots);
    hidden.advance(frame(1), robots);
    const double expected = 0.5 * std::erfc(-beyond / 0.015 / std::numbers::sqrt2);
    EXPECT_NEAR(hidden.outside(frame(1), robots), expected, 1e-3);  // of a hypothesis that is dropped
  }
}

TEST(HiddenBall, HullsPushIt) {
  // It lies behind blue; yellow's round side comes from the left and drives over its place.
  const Vector2d ball = Vector2d(-1, -1) + 0.12 * away;
  const Vector2d along(-away.y(), away.x());
  std::vector<world::TrackedRobot> robots = {robot_at(yellow_3, ball + 0.15 * along + 0.05 * away, along),
                                             robot_at(blue_2, {-1, -1}, -away)};
  HiddenBall hidden(with_cameras());
  hidden.start({ball, Vector2d::Zero()}, frame(0), robots);
  for (int n = 1; n <= 12; ++n) {
    robots[0].position -= 0.005 * along;
    robots[0].velocity = -0.3 * along;
    hidden.advance(frame(n), robots);
    for (const world::TrackedRobot& robot : robots) {
      const Vector2d place = hidden.best(frame(n), robots).position;
      // Two hulls may squeeze it for a frame.
      EXPECT_GT(HiddenBall::gap(world::Field{}, robot, place).distance, -0.005) << n;
    }
  }
  EXPECT_LT(hidden.best(frame(12), robots).velocity.dot(along), -0.1);
}

TEST(HiddenBall, GapKnowsTheFlatFront) {
  const world::TrackedRobot robot = robot_at(yellow_3, {0, 0}, {1, 0});
  const world::Field field;
  const auto gap = [&](double x, double y) { return HiddenBall::gap(field, robot, {x, y}); };
  const double r = field.ball_radius;
  EXPECT_NEAR(gap(0.073 + r + 0.01, 0.02).distance, 0.01, 1e-12);
  EXPECT_TRUE(gap(0.073 + r + 0.01, 0.02).at_front);
  EXPECT_NEAR(gap(-0.09 - r - 0.01, 0).distance, 0.01, 1e-12);
  EXPECT_FALSE(gap(-0.09 - r, 0).at_front);
  EXPECT_NEAR(gap(0, 0.1 + r).out.y(), 1, 1e-12);
}

// A robot drives past a resting ball and hides more and more of it from the one camera near. The camera
// reports the middle of what it sees, up to 11 mm off. Second method: the simulator's exact occlusion.
TEST(Tracker, PartlyHiddenBallStaysWhereItLies) {
  const world::Geometry geometry = with_cameras();
  const vision::Occlusion occlusion(world::RobotSpecs{}, geometry.field.ball_radius);
  const world::Camera& camera = geometry.cameras.at(0);
  const Vector2d side = camera.position.head<2>();
  const Vector2d ball = side + Vector2d(0.9, 0.6);
  const Vector2d out = (ball - side).normalized();
  const Vector2d along(-out.y(), out.x());
  for (const double heading : {0.3, 2.0, -2.5}) {
    Tracker tracker{geometry};
    double worst = 0, worst_report = 0, fastest = 0;
    for (int n = 1; n < 200; ++n) {
      const Vector2d place = ball - 0.12 * out + (0.3 - 0.002 * n) * along;  // 0.12 m/s
      truth::Robot robot{.id = yellow_3, .position = place, .orientation = heading};
      const Vector3d centre(ball.x(), ball.y(), geometry.field.ball_radius);
      const auto view = occlusion.view(camera.position, centre, std::span(&robot, 1));
      world::Detection image;
      image.camera = camera.id;
      image.t_capture = frame(n);
      image.robots.push_back({});
      image.robots.back().team = yellow_3.team;
      image.robots.back().number = yellow_3.number;
      image.robots.back().position = place;
      image.robots.back().orientation = heading;
      if (view.share >= 0.4) {
        // Followed to the height of a resting ball's centre, as the cameras do.
        const Vector3d ray = view.center - camera.position;
        const double t = (geometry.field.ball_radius - camera.position.z()) / ray.z();
        image.balls.push_back({});
        image.balls.back().position = (camera.position + t * ray).head<2>();
        worst_report = std::max(worst_report, (image.balls.back().position - ball).norm());
      }
      const world::TrackedFrame* tracked = tracker.update(std::span(&image, 1));
      if (!tracked || !tracked->ball || view.share < 0.4) continue;
      worst = std::max(worst, (tracked->ball->position.head<2>() - ball).norm());
      fastest = std::max(fastest, tracked->ball->velocity.norm());
    }
    EXPECT_GT(worst_report, 0.007) << heading;  // else the scene would show nothing
    EXPECT_LT(worst, 0.005) << heading;         // edges are not straight: half of what is reported
    EXPECT_LT(fastest, 0.2) << heading;         // 0.3 m/s without
  }
}

}  // namespace
}  // namespace tracker
