#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "autoref/calibrate/bias.h"
#include "autoref/calibrate/calibration.h"
#include "sim/world/random.h"
#include "tests/autoref/calibrate/scene.h"

// Images with errors that are known exactly: what is found must be what was made, within the errors stated.

namespace calibrate {
namespace {

using world::Vector2d;

Observations observed(const std::vector<world::Detection>& images) {
  Observer observer;
  for (const world::Detection& image : images) observer.add(image);
  return observer.finish();
}

Report report_of(int cameras, double seconds, const scene::Errors& errors, std::uint64_t seed) {
  return calibrated(observed(scene::images(cameras, seconds, errors, seed)), scene::geometry(cameras));
}

// Within 3 standard errors; every seed here is fixed, so it holds or not for good.
void expect_found(const Report& report, std::string_view key, double truth) {
  const Finding* found = report.find(key);
  ASSERT_NE(found, nullptr) << key;
  ASSERT_TRUE(found->value) << key << ": " << found->missing;
  EXPECT_NEAR(*found->value, truth, 3 * found->error) << key;
  std::cout << "  " << key << ": truth " << truth << ", found " << *found->value << " +- " << found->error
            << "\n";
}

TEST(Cameras, NoiseOfBallRobotsOrientationAndArea) {
  scene::Errors errors;
  errors.ball_sigma = 0.0014;
  errors.robot_sigma = 0.0007;
  errors.orientation_sigma = 0.01;
  errors.area_sigma = 6.5;
  const Report report = report_of(4, 60, errors, 1);
  expect_found(report, "vision.ball_sigma", 0.0014);
  expect_found(report, "vision.robot_sigma", 0.0007);
  expect_found(report, "vision.orientation_sigma", 0.01);
  expect_found(report, "vision.area_sigma", 6.5);
}

// A camera whose clock is off by 1 ms now and then: at 0.8 m/s that is 0.8 mm along the way, none across it.
TEST(Cameras, NoiseIsNotThatOfTheClock) {
  std::vector<world::Detection> images = scene::images(4, 60, {}, 12);
  world::RandomStream random(12, "clock");
  for (world::Detection& image : images) image.t_capture += world::from_seconds(0.001 * random.gaussian());
  const Report report = calibrated(observed(images), scene::geometry(4));
  expect_found(report, "vision.robot_sigma", 0.0005);
  const auto along = std::ranges::find_if(report.findings(), [](const Finding& f) {
    return f.quantity.find("along") != std::string::npos && *f.value > 0.0008;
  });
  EXPECT_NE(along, report.findings().end());
}

TEST(Cameras, TheirPlacesRatesAndDelay) {
  const Report report = report_of(4, 60, {}, 2);
  EXPECT_EQ(*report.find("vision.cameras")->value, 4);
  EXPECT_DOUBLE_EQ(*report.find("vision.camera_height")->value, 4.2);
  // A robot passes the edge at 0.8 m/s, so the last image before it is up to 13 mm away, the noise beyond.
  EXPECT_NEAR(*report.find("vision.overlap")->value, scene::overlap, 0.015);
  EXPECT_EQ(*report.find("vision.delay")->value, 1);  // 0.02 s is 1.2 ticks
}

// Two cameras: offsets of half the difference each, sigma^2 = |D|^2 / 4.
TEST(Cameras, BiasOfTwoIsHalfTheirDistance) {
  scene::Errors errors;
  errors.offsets = {{0.012, -0.004}, {-0.008, 0.011}};
  const Report report = report_of(2, 30, errors, 3);
  const double truth = (errors.offsets[0] - errors.offsets[1]).norm() / 2;
  // Noise of a median of hundreds of differences of 0.7 mm, and 0.1 mm of interpolation on the circles.
  EXPECT_NEAR(*report.find("vision.bias_sigma")->value, truth, 0.0002);
}

TEST(Cameras, BiasOfFourIsThatOfTheirOffsetsAroundTheMean) {
  scene::Errors errors;
  errors.offsets = {{0.012, -0.004}, {-0.008, 0.011}, {0.003, 0.009}, {-0.015, 0.001}};
  Vector2d mean(0, 0);
  for (const Vector2d& offset : errors.offsets) mean += offset / 4;
  double squares = 0;
  for (const Vector2d& offset : errors.offsets) squares += (offset - mean).squaredNorm();
  const Report report = report_of(4, 60, errors, 4);
  EXPECT_NEAR(*report.find("vision.bias_sigma")->value, std::sqrt(squares / 6), 0.0002);
}

// Over many draws sigma^2 is right in the mean: 40 draws of 6 degrees of freedom know it to 9 %.
TEST(Cameras, BiasIsUnbiased) {
  world::RandomStream random(5, "offsets");
  double mean_square = 0;
  for (std::uint64_t draw = 0; draw < 40; ++draw) {
    scene::Errors errors;
    for (int i = 0; i < 4; ++i)
      errors.offsets.emplace_back(0.01 * random.gaussian(), 0.01 * random.gaussian());
    Report report;
    add_bias(observed(scene::images(4, 5, errors, draw)), report);
    mean_square += std::pow(*report.find("vision.bias_sigma")->value, 2) / 40;
  }
  EXPECT_NEAR(mean_square, 1e-4, 3 * 0.09 * 1e-4);
}

TEST(Cameras, LossesOfTheBallAndOfRobotsInBursts) {
  scene::Errors errors;
  errors.ball = {0.03, 0.004, 12};
  errors.robot = {0.01, 0.0005, 10};
  const Report report = report_of(2, 600, errors, 6);
  expect_found(report, "vision.ball_missing", 0.03);
  expect_found(report, "vision.ball_burst_start", 0.004);
  expect_found(report, "vision.ball_burst_length", 12);
  expect_found(report, "vision.robot_missing", 0.01);
  expect_found(report, "vision.robot_burst_start", 0.0005);
  expect_found(report, "vision.robot_burst_length", 10);
}

TEST(Cameras, SingleMissesAreNoBursts) {
  scene::Errors errors;
  errors.ball = {0.05, 0, 5};
  errors.robot = {0.02, 0, 5};
  const Report report = report_of(4, 120, errors, 7);
  expect_found(report, "vision.ball_missing", 0.05);
  expect_found(report, "vision.robot_missing", 0.02);
  EXPECT_EQ(*report.find("vision.ball_burst_start")->value, 0);
  EXPECT_EQ(*report.find("vision.robot_burst_start")->value, 0);
  EXPECT_EQ(report.find("vision.ball_burst_length"), nullptr);
}

// An image that nobody received is no loss of what was in it.
TEST(Cameras, ImagesThatNeverCameAreNoLosses) {
  std::vector<world::Detection> images = scene::images(2, 60, {}, 8);
  world::RandomStream random(8, "network");
  std::erase_if(images, [&](const world::Detection&) { return random.uniform() < 0.05; });
  const Report report = calibrated(observed(images), scene::geometry(2));
  EXPECT_EQ(*report.find("vision.ball_missing")->value, 0);
  EXPECT_EQ(*report.find("vision.robot_missing")->value, 0);
}

TEST(Cameras, FalseBallsAndTheirLengths) {
  scene::Errors errors;
  errors.false_ball_rate = 0.1;
  const Report report = report_of(2, 600, errors, 9);
  expect_found(report, "vision.false_ball_rate", 0.1);
  // 2.5 % and 97.5 % quantiles of 3 to 30 are 3 and 30; two that touch in time and place count as one.
  EXPECT_NEAR(*report.find("vision.false_ball_shortest")->value, 3, 1);
  EXPECT_NEAR(*report.find("vision.false_ball_longest")->value, 30, 2);
  // They disturb nothing else.
  expect_found(report, "vision.ball_sigma", 0.0005);
  EXPECT_LT(*report.find("vision.ball_missing")->value, 1e-4);
}

TEST(Cameras, MisreadAndUnreadRobotsAreNoLosses) {
  scene::Errors errors;
  errors.misread = 0.004;
  errors.unread = 0.002;
  const Report report = report_of(4, 120, errors, 10);
  // One in sixteen misreadings hits the right number.
  expect_found(report, "vision.misread_id", 0.004 * 15 / 16);
  expect_found(report, "vision.unread_id", 0.002);
  // A misreading as the number of a robot that left this camera's view may be taken for it: one in twenty.
  EXPECT_LT(*report.find("vision.robot_missing")->value, 0.006 / 20);
}

TEST(Cameras, OfTooLittleTellNothing) {
  const Report report = report_of(2, 0.5, {}, 11);
  for (const char* key : {"vision.false_ball_rate", "vision.ball_missing", "ball.roll_deceleration"}) {
    ASSERT_NE(report.find(key), nullptr) << key;
    EXPECT_FALSE(report.find(key)->value) << key;
    EXPECT_FALSE(report.find(key)->missing.empty()) << key;
  }
}

}  // namespace
}  // namespace calibrate
