#include "sim/vision/occlusion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "sim/world/random.h"
#include "tests/sim/vision/scene.h"

namespace {

using vision::BallView;
using vision::Cameras;
using vision::Occlusion;
using vision::Params;
using world::Vector2d;
using world::Vector3d;

constexpr double r = 0.0215;
const world::RobotSpecs body;
const Occlusion occlusion(body, r);
const Vector3d eye(0, 0, 4);

// Does the ray enter the cylinder with flat front before `limit`? Nothing of sim/vision is used.
bool hits(const Vector3d& origin, const Vector3d& ray, const truth::Robot& robot, double limit) {
  double enter = 0, leave = limit;
  const auto keep = [&](double from, double to) {
    enter = std::max(enter, from);
    leave = std::min(leave, to);
  };
  keep((body.height - origin.z()) / ray.z(), -origin.z() / ray.z());  // rays go down
  const Vector2d o = origin.head<2>() - robot.position, d = ray.head<2>();
  const double a = d.squaredNorm(), b = o.dot(d), c = o.squaredNorm() - body.radius * body.radius;
  if (b * b - a * c <= 0) return false;
  keep((-b - std::sqrt(b * b - a * c)) / a, (-b + std::sqrt(b * b - a * c)) / a);
  const Vector2d forward(std::cos(robot.orientation), std::sin(robot.orientation));
  const double before = body.center_to_dribbler - o.dot(forward), speed = d.dot(forward);
  if (speed > 0) keep(-1e9, before / speed);
  if (speed < 0) keep(before / speed, 1e9);
  return enter < leave;
}

struct Sampled {
  double share = 0;
  Vector3d center = Vector3d::Zero();
};

// The ball's disc by a grid of rays; a ray is blocked when it meets a robot before the ball's surface.
Sampled by_rays(const Vector3d& camera, const Vector3d& ball, const std::vector<truth::Robot>& robots) {
  constexpr int half = 40;
  const Vector3d sight = (ball - camera).normalized();
  const double distance = (ball - camera).norm();
  const double disc = r / std::sqrt(1 - r * r / (distance * distance));
  const Vector3d across = sight.unitOrthogonal(), other = sight.cross(across);
  int all = 0, visible = 0;
  Sampled result;
  for (int i = -half; i < half; ++i) {
    for (int j = -half; j < half; ++j) {
      const double x = (i + 0.5) / half, y = (j + 0.5) / half;
      if (x * x + y * y > 1) continue;
      const Vector3d point = ball + disc * (x * across + y * other);
      const Vector3d ray = (point - camera).normalized();
      const double along = (ball - camera).dot(ray);
      const double half_chord2 = along * along - (distance * distance - r * r);
      const double surface = along - std::sqrt(std::max(half_chord2, 0.0));
      ++all;
      if (std::any_of(robots.begin(), robots.end(),
                      [&](const auto& robot) { return hits(camera, ray, robot, surface); })) {
        continue;
      }
      ++visible;
      result.center += point;
    }
  }
  result.share = static_cast<double>(visible) / all;
  if (visible > 0) result.center /= visible;
  return result;
}

// Is the ball outside the robot's body?
bool apart(const Vector3d& ball, const truth::Robot& robot) {
  const Vector2d local = world::rotated(ball.head<2>() - robot.position, -robot.orientation);
  if (ball.z() > body.height + r) return true;
  if (local.x() > body.center_to_dribbler + r) return true;
  return local.norm() > body.radius + r;
}

// The grid of 80 by 80 errs by less than half a column, 0.008 of the disc; the facets by at most 0.5 mm of a
// chord of 43 mm, 0.015, for each edge that crosses the disc.
constexpr double share_tolerance = 0.02, tolerance_of_two_edges = 0.035;

void expect_agreement(int robots_at_ball, std::uint64_t seed, int trials) {
  world::RandomStream random(seed, "occlusion");
  const double tolerance = robots_at_ball == 1 ? share_tolerance : tolerance_of_two_edges;
  int partly = 0, hidden = 0, free = 0;
  double worst = 0, sum = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Vector3d camera(0.3, -0.2, 3 + 2 * random.uniform());
    Vector3d ball(6 * random.uniform() - 3, 5 * random.uniform() - 2.5, r);
    if (random.uniform() < 0.3) ball.z() += 0.2 * random.uniform();
    std::vector<truth::Robot> robots;
    while (static_cast<int>(robots.size()) < robots_at_ball) {
      const Vector2d beside = (0.09 + 0.15 * random.uniform()) * world::direction(7 * random.uniform());
      truth::Robot robot =
          scene::robot_at(ball.x() + beside.x(), ball.y() + beside.y(), 7 * random.uniform());
      if (apart(ball, robot)) robots.push_back(robot);
    }
    const Sampled expected = by_rays(camera, ball, robots);
    const BallView found = occlusion.view(camera, ball, robots);
    EXPECT_NEAR(found.share, expected.share, tolerance) << "trial " << trial;
    worst = std::max(worst, std::abs(found.share - expected.share));
    sum += found.share - expected.share;
    if (expected.share > 0.3) {
      // What is wrongly counted lies at most a radius away: tolerance / 0.3 of a radius.
      EXPECT_LT((found.center - expected.center).norm(), r * tolerance / 0.3) << "trial " << trial;
    }
    ++(expected.share == 0 ? hidden : expected.share == 1 ? free : partly);
  }
  // Each kind has to be among them, or nothing was tested.
  EXPECT_GT(partly, 50);
  EXPECT_GT(free, 50);
  EXPECT_GT(hidden, 20);
  EXPECT_NEAR(sum / trials, 0, 0.002);  // no bias: the facets have the cylinder's area
  testing::Test::RecordProperty("partly", partly);
  testing::Test::RecordProperty("hidden", hidden);
  testing::Test::RecordProperty("worst", std::to_string(worst));
  testing::Test::RecordProperty("mean", std::to_string(sum / trials));
}

TEST(Occlusion, ByOneRobotAgreesWithRays) { expect_agreement(1, 1, 3000); }
TEST(Occlusion, ByTwoRobotsAgreesWithRays) { expect_agreement(2, 2, 1500); }
TEST(Occlusion, ByFourRobotsAgreesWithRays) { expect_agreement(4, 3, 700); }

TEST(Occlusion, ARobotRightBetweenHidesTheBall) {
  // 2 m out the top's edge hides what lies within 0.15 x 2 / 3.85 = 78 mm behind it: the whole ball.
  const BallView view = occlusion.view(eye, {2, 0, r}, std::vector{scene::robot_at(2 - 0.09 - r, 0, 0)});
  EXPECT_LT(view.share, 1e-9);
}

TEST(Occlusion, ABallInFrontIsNeverHidden) {
  for (double turn = 0; turn < 6.3; turn += 0.1) {
    const truth::Robot robot = scene::robot_at(2.1, 1.3, turn);
    const double towards = world::angle_of(-robot.position);
    for (double spread = -1.2; spread <= 1.2; spread += 0.1) {
      // At the round side, and at the front where that is nearer.
      const double angle = towards + spread;
      const double from_front = std::cos(angle - turn);
      double distance = 0.09 + r;
      if (from_front > 0) distance = std::min(distance, std::max((0.073 + r) / from_front, 0.073 + r));
      const Vector2d ball = robot.position + (distance + 1e-9) * world::direction(angle);
      const Vector3d place(ball.x(), ball.y(), r);
      if (!apart(place, robot)) continue;
      const double share = occlusion.view(eye, place, std::vector{robot}).share;
      EXPECT_GE(share, by_rays(eye, place, {robot}).share - share_tolerance);
      if (std::abs(spread) < 0.8) {
        EXPECT_EQ(share, 1) << turn << ' ' << spread;
      }
    }
  }
}

TEST(Occlusion, ADribbledBallIsSeenFromTheFrontAndHiddenFromBehind) {
  const truth::Robot facing = scene::robot_at(2, 0, std::numbers::pi), turned = scene::robot_at(2, 0, 0);
  EXPECT_EQ(occlusion.view(eye, {2 - 0.0945, 0, r}, std::vector{facing}).share, 1);
  EXPECT_LT(occlusion.view(eye, {2 + 0.0945, 0, r}, std::vector{turned}).share, 0.1);
}

TEST(Occlusion, NothingIsHiddenUnderTheCamera) {
  const std::vector robots = {scene::robot_at(0.09 + r, 0, 1), scene::robot_at(-0.09 - r, 0, 2)};
  EXPECT_EQ(occlusion.view({0, 0, 4}, {0, 0, r}, robots).share, 1);
}

TEST(Occlusion, ABallOnOrAboveRobotsIsNeverHidden) {
  const std::vector robots = {scene::robot_at(2, 0, 1), scene::robot_at(1.82, 0, 2)};
  EXPECT_EQ(occlusion.view(eye, {2, 0, 0.15 + r}, robots).share, 1);
  EXPECT_EQ(occlusion.view(eye, {2.05, 0, 0.15 + r}, robots).share, 1);
  EXPECT_EQ(occlusion.view(eye, {2.2, 0, 0.5}, robots).share, 1);
}

TEST(Occlusion, HalfIsHiddenWhereTheEdgePassesThroughTheMiddle) {
  // A straight edge would leave half of the disc. The edge is an arc of radius R, 93 mm,
  // which bends away from the ball: by y^2 / (2 R) at the distance y, r^2 / (6 R) in the mean over the
  // chord of 2 r, 2.5 % of the disc.
  const double scale = (4 - r) / (4 - 0.15);
  const double edge = 2 * scale + 0.09 * scale;  // the far end of the top's shadow at the ball's height
  const BallView view =
      occlusion.view(eye, {edge, 0, r}, std::vector{scene::robot_at(2, 0, std::numbers::pi)});
  const double bend = r * r / (6 * 0.09 * scale) * 2 / (std::numbers::pi * r);
  EXPECT_NEAR(view.share, 0.5 + bend, 0.01);  // facets: 0.25 mm x 43 mm of 1452 mm^2
  EXPECT_GT(bend, 0.02);
  // A half disc's centroid is 4 / (3 pi) radii from its middle.
  EXPECT_NEAR((view.center - Vector3d(edge, 0, r)).norm(), 4 * r / (3 * std::numbers::pi), 0.05 * r);
  EXPECT_GT(view.center.x(), edge);  // away from the robot
}

TEST(Occlusion, TurnsWithTheScene) {
  const std::vector robots = {scene::robot_at(1.9, 0.02, 0.4), scene::robot_at(2, -0.17, 2)};
  const Vector3d ball(2.06, -0.02, r);
  const BallView here = occlusion.view(eye, ball, robots);
  ASSERT_GT(here.share, 0.05);
  ASSERT_LT(here.share, 0.95);
  for (double turn = 0.3; turn < 6.3; turn += 0.3) {
    std::vector<truth::Robot> turned = robots;
    for (truth::Robot& robot : turned) {
      robot.position = world::rotated(robot.position, turn);
      robot.orientation += turn;
    }
    const Vector2d b = world::rotated(ball.head<2>(), turn);
    const BallView there = occlusion.view(eye, {b.x(), b.y(), r}, turned);
    EXPECT_NEAR(there.share, here.share, 1e-12);  // rounding
    EXPECT_NEAR((there.center.head<2>() - world::rotated(here.center.head<2>(), turn)).norm(), 0, 1e-12);
  }
}

TEST(Occlusion, StaysFiniteWhenTheBallIsPressedIntoARobot) {
  for (double x = 1.85; x < 2.15; x += 0.001) {
    const BallView view = occlusion.view(eye, {x, 0, r}, std::vector{scene::robot_at(2, 0, 0.3)});
    EXPECT_TRUE(view.share >= 0 && view.share <= 1 && view.center.allFinite()) << x;
  }
}

// A camera that sees less than its share of the ball does not report it; another one may.
TEST(Occlusion, IsEachCamerasOwn) {
  Cameras cameras(scene::geometry(), Params{.overlap = 3, .visible_share = 0.4}, 1);
  // West of the robot: cameras 0 and 1 (at x = -2.25) see it, 2 and 3 (at 2.25) do not.
  const auto frames = scene::tick(cameras, 0, scene::ball_at(-0.112, 0), {scene::robot_at(0, 0, 0)});
  ASSERT_EQ(frames.size(), 4U);
  EXPECT_EQ(frames[0].balls.size(), 1U);
  EXPECT_EQ(frames[1].balls.size(), 1U);
  EXPECT_EQ(frames[2].balls.size(), 0U);
  EXPECT_EQ(frames[3].balls.size(), 0U);
}

TEST(Occlusion, APartOfABallIsReportedSmallerAndAside) {
  const std::vector robots = {scene::robot_at(-1, -1.5, std::numbers::pi)};
  const auto camera = scene::geometry().cameras[0];
  Cameras blind(scene::geometry(), Params{}, 1), sharp(scene::geometry(), Params{.visible_share = 0.05}, 1);
  int parts = 0;
  for (int i = 0; i < 60; ++i) {
    const truth::Ball ball = scene::ball_at(-0.888 + 0.001 * i, -1.5);
    const BallView view = occlusion.view(camera.position, ball.position, robots);
    const auto whole = scene::tick(blind, i, ball, robots)[0], part = scene::tick(sharp, i, ball, robots)[0];
    ASSERT_EQ(whole.balls.size(), 1U);
    ASSERT_EQ(part.balls.size(), view.share < 0.05 ? 0U : 1U);
    if (view.share < 0.05 || view.share == 1) continue;
    ++parts;
    EXPECT_EQ(part.balls[0].area, std::lround(vision::ball_area(camera, ball.position, r) * view.share));
    // The ray through the middle of the visible part, by hand: heights from the resting ball's centre.
    const Vector3d way = view.center - camera.position;
    const double scale = camera.position.z() / (camera.position.z() - (view.center.z() - r));
    EXPECT_NEAR(part.balls[0].position.x(), camera.position.x() + way.x() * scale,
                1e-6);  // float millimetres
    EXPECT_GT(part.balls[0].position.x(), whole.balls[0].position.x());
  }
  EXPECT_GT(parts, 10);
}

TEST(Occlusion, RobotsDoNotHideEachOther) {
  Cameras cameras(scene::geometry(), Params{.visible_share = 1}, 1);
  std::vector<truth::Robot> robots;
  for (int i = 0; i < 6; ++i) robots.push_back(scene::robot_at(-0.3 - 0.18 * i, -1.5, 0, i));
  EXPECT_EQ(scene::tick(cameras, 0, scene::ball_at(3, 2), robots)[0].robots.size(), 6U);
}

}  // namespace
