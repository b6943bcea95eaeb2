// What the cameras report against five seconds of a real game of RoboCup 2022: 366 balls and 6257 robots.
//
// The file has no licence and is not in the repository; without it these tests are skipped.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "sim/vision/optics.h"
#include "sim/wire/log_messages.h"
#include "sim/wire/vision.h"

namespace {

using world::Vector2d;
using world::Vector3d;
using Calibration = wire::proto::SSL_GeometryCameraCalibration;

struct InCamera {
  Vector2d pixel;
  double distance, depth;  // [mm]
};

// The published formula with distortion (protocol.md, 2.1); millimetres.
InCamera project(const Calibration& calibration, const Vector3d& point) {
  const Eigen::Quaterniond q(calibration.q3(), calibration.q0(), calibration.q1(), calibration.q2());
  const Vector3d p = q.normalized() * point + Vector3d(calibration.tx(), calibration.ty(), calibration.tz());
  const Vector2d straight = p.head<2>() / p.z();
  double radius = straight.norm();
  for (int i = 0; i < 20; ++i) radius = straight.norm() / (1 + calibration.distortion() * radius * radius);
  const Vector2d principal(calibration.principal_point_x(), calibration.principal_point_y());
  return {static_cast<double>(calibration.focal_length()) * straight.normalized() * radius + principal,
          p.norm(), p.z()};
}

class RealDetections : public testing::Test {
 protected:
  void SetUp() override {
    const char* given = std::getenv("MATCHDAY_REAL_LOG");
    const std::filesystem::path path =
        given ? given : SOURCE_DIR "/../shared/data/robocup2022_kiks_vs_erforce_5s.log";
    if (!given && !std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    wire::LogReader reader(path);
    wire::LogRecord record;
    while (reader.next(record)) {
      wire::proto::SSL_WrapperPacket packet;
      if (!wire::read(record, packet)) continue;
      if (packet.has_detection()) frames_.push_back(packet.detection());
      for (const Calibration& one : packet.geometry().calib()) calibrations_[one.camera_id()] = one;
    }
    ASSERT_EQ(frames_.size(), 732U);
    ASSERT_EQ(calibrations_.size(), 2U);
  }

  std::vector<wire::proto::SSL_DetectionFrame> frames_;
  std::map<std::uint32_t, Calibration> calibrations_;
};

// The league's vision takes the pixel of a ball for a point at a set height, 30 mm here, and of a robot for a
// point at its team's height, which it also sends. Both to a float.
TEST_F(RealDetections, PixelsFollowThePublishedFormula) {
  constexpr double float_pixels = 5e-3;  // of floats of 10 m, 1 mm, through lenses of 1449 px at 6 m
  for (const auto& frame : frames_) {
    const Calibration& calibration = calibrations_[frame.camera_id()];
    for (const auto& ball : frame.balls()) {
      const InCamera seen = project(calibration, {ball.x(), ball.y(), 30});
      EXPECT_LT((seen.pixel - Vector2d(ball.pixel_x(), ball.pixel_y())).norm(), float_pixels);
    }
    for (const auto* robots : {&frame.robots_yellow(), &frame.robots_blue()}) {
      for (const auto& robot : *robots) {
        const InCamera seen = project(calibration, {robot.x(), robot.y(), robot.height()});
        EXPECT_LT((seen.pixel - Vector2d(robot.pixel_x(), robot.pixel_y())).norm(), float_pixels);
      }
    }
  }
}

TEST_F(RealDetections, ConfidencesFollowTheFormula) {
  for (const auto& frame : frames_) {
    for (const auto& ball : frame.balls()) {
      EXPECT_NEAR(vision::ball_confidence(ball.area()), static_cast<double>(ball.confidence()),
                  1e-7);  // a float
    }
    for (const auto* robots : {&frame.robots_yellow(), &frame.robots_blue()}) {
      for (const auto& robot : *robots) {
        EXPECT_NEAR(vision::robot_confidence, static_cast<double>(robot.confidence()), 0.0016);
      }
    }
  }
}

// A real blob is smaller than the disc: the colour ends inside the rim. 0.78 of it in the mean here.
TEST_F(RealDetections, AreasAreMostOfTheDisc) {
  double sum = 0;
  int count = 0;
  for (const auto& frame : frames_) {
    const Calibration& calibration = calibrations_[frame.camera_id()];
    for (const auto& ball : frame.balls()) {
      const InCamera seen = project(calibration, {ball.x(), ball.y(), 21.5});
      world::Camera straight;
      straight.position = {0, 0, seen.depth / 1000};
      straight.focal_length = static_cast<double>(calibration.focal_length());
      const double beside = std::sqrt(seen.distance * seen.distance - seen.depth * seen.depth) / 1000;
      sum += ball.area() / vision::ball_area(straight, {beside, 0, 0}, 0.0215);
      ++count;
    }
  }
  EXPECT_NEAR(sum / count, 0.78, 0.01);  // a measurement of this log
}

}  // namespace
