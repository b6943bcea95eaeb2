#include "sim/vision/optics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "sim/wire/vision.h"
#include "tests/sim/vision/scene.h"

namespace {

using vision::Cameras;
using vision::Params;
using world::Vector2d;
using world::Vector3d;

// The pixel of a point [m] by the formula published for the geometry message
// (protocol.md, 2.1), nothing else.
Vector2d by_the_message(const wire::proto::SSL_GeometryCameraCalibration& calibration,
                        const Vector3d& point) {
  const Eigen::Quaterniond q(calibration.q3(), calibration.q0(), calibration.q1(), calibration.q2());
  const Vector3d t(calibration.tx(), calibration.ty(), calibration.tz());
  const Vector3d in_camera = q * (point * 1000) + t;
  const Vector2d principal(calibration.principal_point_x(), calibration.principal_point_y());
  return static_cast<double>(calibration.focal_length()) * in_camera.head<2>() / in_camera.z() + principal;
}

// Floats next to 1000 px are 6e-5 px apart, millimetres next to 5000 are 5e-4 apart: 1e-4 px.
constexpr double float_pixels = 3e-4;

TEST(Optics, PixelsAreThoseOfTheGeometryMessage) {
  world::Geometry geometry = scene::geometry();
  geometry.cameras[1].focal_length = 700;
  geometry.cameras[2].image_width = 2000;
  wire::proto::SSL_GeometryData message;
  wire::encode(geometry, message);
  Cameras cameras(geometry, Params{.ball_sigma = 0.01, .robot_sigma = 0.01}, 3);
  int seen = 0;
  for (int i = 0; i < 50; ++i) {
    const double x = -4 + 0.16 * i, y = 2.5 * std::sin(i);
    const auto frames = scene::tick(cameras, i, scene::ball_at(x, y), {scene::robot_at(-x, y, 0)});
    for (std::size_t c = 0; c < 4; ++c) {
      const auto& calibration = message.calib(static_cast<int>(c));
      for (const auto& ball : frames[c].balls) {  // balls are at the height of their centre
        const Vector2d& p = ball.position;
        EXPECT_LT((by_the_message(calibration, {p.x(), p.y(), 0.0215}) - ball.pixel).norm(), float_pixels);
        ++seen;
      }
      for (const auto& robot : frames[c].robots) {  // patterns are at the top of the robot
        const Vector2d& p = robot.position;
        EXPECT_LT((by_the_message(calibration, {p.x(), p.y(), 0.15}) - robot.pixel).norm(), float_pixels);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(Optics, ABiasedCameraReportsTheRightPixelAndAWrongPlace) {
  Cameras right(scene::geometry(), Params{}, 3), wrong(scene::geometry(), Params{.bias_sigma = 0.01}, 3);
  const auto a = scene::tick(right, 0, scene::ball_at(-1, -2)),
             b = scene::tick(wrong, 0, scene::ball_at(-1, -2));
  EXPECT_EQ(a[0].balls.at(0).pixel, b[0].balls.at(0).pixel);
  EXPECT_NE(a[0].balls[0].position, b[0].balls[0].position);
}

// A ball in the air has the pixel of the place it is reported at. That is not quite the pixel of its centre,
// because the ray is followed by the league's formula, which counts heights from the resting ball's centre
// but the camera's from the carpet: less by the share r z / ((H - r) (H - z)) of the way from the middle.
TEST(Optics, AnAirbornePixelIsNearlyThatOfTheCentre) {
  const world::Geometry geometry = scene::geometry();
  const world::Camera& camera = geometry.cameras[0];
  Cameras cameras(geometry, Params{}, 3);
  const Vector3d ball(-1, -2.5, 0.0215 + 0.7);
  const auto frames = scene::tick(cameras, 0, scene::ball_at(ball.x(), ball.y(), 0.7));
  const Vector2d middle(640, 512), of_center = vision::pixel_of(camera, ball);
  const double share = 0.0215 * 0.7 / ((4 - 0.0215) * (4 - 0.7));
  const Vector2d expected = middle + (1 - share) * (of_center - middle);
  EXPECT_LT((frames[0].balls.at(0).pixel - expected).norm(), float_pixels);
  EXPECT_LT((frames[0].balls[0].pixel - of_center).norm(), 0.5);
}

TEST(Optics, AreaOfABallUnderTheCameraIsThatOfADisc) {
  const world::Camera camera{0, {1, 2, 4}};
  const double depth = 4 - 0.0215;
  // r / d to second order is 3e-5 of it.
  EXPECT_NEAR(vision::ball_area(camera, {1, 2, 0.0215}, 0.0215),
              std::numbers::pi * std::pow(800 * 0.0215 / depth, 2), 1e-4 * 58);
}

// Second method: the share of rays through a fine grid of image points that hit the sphere.
TEST(Optics, AreaOfABallBesideAgreesWithRays) {
  const world::Camera camera{0, {0, 0, 4}};
  for (const Vector3d& ball : {Vector3d(2.9, 2.1, 0.0215), Vector3d(-1, 0.5, 1.5), Vector3d(0.3, -2, 3)}) {
    const Vector2d middle = vision::pixel_of(camera, ball);
    const double half = 60, step = 0.05;  // [px]
    int hits = 0;
    for (double u = middle.x() - half; u < middle.x() + half; u += step) {
      for (double v = middle.y() - half; v < middle.y() + half; v += step) {
        const Vector3d ray = Vector3d((u - 640) / 800, (512 - v) / 800, -1).normalized();
        const Vector3d to_ball = ball - camera.position;
        if (to_ball.cross(ray).squaredNorm() < 0.0215 * 0.0215) ++hits;
      }
    }
    const double expected = hits * step * step;
    // Cells on the rim, about 2 pi radius / step of them, are right or wrong by chance: sqrt of their number
    // times a cell, 4 times over.
    const double radius = std::sqrt(expected / std::numbers::pi);
    const double tolerance = 4 * std::sqrt(2 * std::numbers::pi * radius / step) * step * step;
    EXPECT_NEAR(vision::ball_area(camera, ball, 0.0215), expected, tolerance);
  }
}

TEST(Optics, ConfidencesAreThoseOfALeagueLog) {
  // Area and confidence as SSL-Vision sent them at RoboCup 2022, printed with 4 digits.
  EXPECT_NEAR(vision::ball_confidence(61), 0.9782, 5e-5);
  EXPECT_NEAR(vision::ball_confidence(73), 0.9470, 5e-5);
  EXPECT_NEAR(vision::ball_confidence(87), 0.8954, 5e-5);
  EXPECT_EQ(vision::ball_confidence(35), 1);
  EXPECT_LT(vision::ball_confidence(5), 1);
  EXPECT_NEAR(vision::robot_confidence, 0.9523, 1e-4);  // the median there
}

TEST(Optics, AreasScatter) {
  Cameras exact(scene::geometry(), Params{}, 1), noisy(scene::geometry(), Params{.area_sigma = 6.5}, 1);
  const auto ball = scene::ball_at(-1, -2);
  const double area = vision::ball_area(scene::geometry().cameras[0], ball.position, 0.0215);
  EXPECT_EQ(scene::tick(exact, 0, ball)[0].balls.at(0).area, std::lround(area));
  double sum = 0, squares = 0;
  const int count = 4000;
  for (int i = 0; i < count; ++i) {
    const auto frames = scene::tick(noisy, i, ball);
    const double error = frames[0].balls.at(0).area - area;
    sum += error;
    squares += error * error;
    EXPECT_EQ(frames[0].balls[0].confidence,
              world::as_float(vision::ball_confidence(frames[0].balls[0].area)));
  }
  // Rounding adds 1/12 px^2. Mean and mean square within 4 of their standard errors.
  const double variance = 6.5 * 6.5 + 1.0 / 12;
  EXPECT_NEAR(sum / count, 0, 4 * std::sqrt(variance / count));
  EXPECT_NEAR(squares / count, variance, 4 * variance * std::sqrt(2.0 / count));
}

TEST(Optics, AreaStaysFiniteAndAtLeastAPixel) {
  Cameras cameras(scene::geometry(), Params{.area_sigma = 100}, 1);
  for (int i = 0; i < 200; ++i) {
    for (const auto& frame : scene::tick(cameras, i, scene::ball_at(-2.25, -1.5, 0.03 * i))) {
      for (const auto& ball : frame.balls) {
        EXPECT_GE(ball.area, 1U);
        EXPECT_TRUE(ball.position.allFinite() && ball.pixel.allFinite());
        EXPECT_TRUE(ball.confidence >= 0 && ball.confidence <= 1);
      }
    }
  }
}

TEST(Optics, WholeFieldIsSeenInsideTheImages) {
  for (const int count : {1, 2, 4, 6, 8}) {
    for (const double height : {3.0, 4.0, 6.0}) {
      world::Geometry geometry;
      geometry.cameras = world::camera_grid(geometry.field, count, height);
      Cameras cameras(geometry, Params{}, 1);
      for (double x = -5.2; x <= 5.2; x += 0.4) {
        for (double y = -3.7; y <= 3.7; y += 0.37) {
          int balls = 0, robots = 0;
          for (const auto& frame :
               scene::tick(cameras, 0, scene::ball_at(x, y), {scene::robot_at(x, y, 0)})) {
            balls += static_cast<int>(frame.balls.size());
            robots += static_cast<int>(frame.robots.size());
            const auto in_image = [](const Vector2d& pixel) {
              return pixel.x() >= 0 && pixel.x() <= 1280 && pixel.y() >= 0 && pixel.y() <= 1024;
            };
            for (const auto& ball : frame.balls) EXPECT_TRUE(in_image(ball.pixel)) << ball.pixel;
            for (const auto& robot : frame.robots) EXPECT_TRUE(in_image(robot.pixel)) << robot.pixel;
          }
          EXPECT_GE(balls, 1) << count << " cameras: " << x << ' ' << y;
          EXPECT_GE(robots, 1) << count << " cameras: " << x << ' ' << y;
        }
      }
    }
  }
}

}  // namespace
