#include "autoref/tracker/camera_bias.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/world/random.h"

namespace tracker {
namespace {

world::Time at(int n) { return world::tick_time(n); }

Vector2d mean_estimate(const CameraBias& bias, int cameras) {
  Vector2d sum = Vector2d::Zero();
  for (int camera = 0; camera < cameras; ++camera) sum += bias.estimate(camera);
  return sum / cameras;
}

TEST(CameraBias, OneMeasurementOfTwoCamerasIsSplitBetweenThem) {
  // Closed form: prior variance b each, noise r: each takes b / (2 b + r) of the difference, with its sign.
  Params params;
  CameraBias bias(params);
  const double r = 4e-6;
  bias.compare(1, 0, {0.010, -0.004}, r, at(1));
  const double b = params.bias_sigma * params.bias_sigma;
  const double share = b / (2 * b + r + params.local_sigma * params.local_sigma);
  EXPECT_NEAR(bias.estimate(1).x(), 0.010 * share, 1e-7);  // one tick of drift moves it by far less
  EXPECT_NEAR(bias.estimate(1).y(), -0.004 * share, 1e-7);
  EXPECT_LT((bias.estimate(0) + bias.estimate(1)).norm(), 1e-15);
}

TEST(CameraBias, FindsTheOffsetsOfAChainOfCameras) {
  // Six cameras of which only neighbours see one thing; noise of one robot sighting less another.
  const std::array<Vector2d, 6> truth = {Vector2d(0.012, -0.003), {-0.008, 0.001}, {0.002, 0.015},
                                         {-0.011, -0.009},        {0.007, 0.0},    {-0.002, -0.004}};
  CameraBias bias{Params{}};
  world::RandomStream noise(1, "bias");
  for (int n = 1; n <= 500; ++n) {
    for (int camera = 1; camera < 6; ++camera) {
      const Vector2d wobble(0.0008 * noise.gaussian(), 0.0008 * noise.gaussian());
      const auto c = static_cast<std::size_t>(camera);
      bias.compare(camera, camera - 1, truth[c] - truth[c - 1] + wobble, 6e-7, at(n));
    }
  }
  // A camera's offset against its neighbour: 0.8 mm noise over hundreds of
  // measurements, drift lets it forget.
  for (std::size_t c = 1; c < 6; ++c) {
    const int camera = static_cast<int>(c);
    const Vector2d found = bias.estimate(camera) - bias.estimate(camera - 1);
    EXPECT_LT((found - (truth[c] - truth[c - 1])).norm(), 0.0005) << camera;
  }
  EXPECT_LT(mean_estimate(bias, 6).norm(), 1e-12);  // rounding only
}

TEST(CameraBias, FalseDifferencesHardlyMoveIt) {
  CameraBias bias{Params{}};
  world::RandomStream chance(2, "false");
  for (int n = 1; n <= 600; ++n) {
    const bool wrong = chance.below(10) == 0;
    bias.compare(1, 0, wrong ? Vector2d(0.12, -0.1) : Vector2d(0.008, 0.002), 6e-7, at(n));
  }
  // Every tenth pulls with three sigmas of 3 mm instead of 120 mm: the balance lies where 0.9 x = 0.1 x 9 mm,
  // 1 mm per axis, and wanders about that.
  EXPECT_LT((bias.estimate(1) - bias.estimate(0) - Vector2d(0.008, 0.002)).norm(), 0.0025);
}

TEST(CameraBias, IsBoundedAndFollowsSlowly) {
  const Params params;
  CameraBias bias(params);
  Vector2d before = bias.applied(1);
  for (int n = 1; n <= 6000; ++n) {
    bias.compare(1, 0, {0.5, 0}, 6e-7, at(n));
    bias.advance();
    EXPECT_LE((bias.applied(1) - before).cwiseAbs().maxCoeff(), 0.0002 + 1e-12);
    before = bias.applied(1);
  }
  EXPECT_NEAR(bias.estimate(1).x(), params.largest_bias, 1e-9);
  EXPECT_NEAR(bias.applied(1).x(), params.largest_bias, 1e-6);
}

TEST(CameraBias, IgnoresCamerasBeyondTheSixteenthAndOneAgainstItself) {
  CameraBias bias{Params{}};
  bias.compare(3, 3, {1, 1}, 1e-6, at(1));
  EXPECT_EQ(bias.estimate(3), Vector2d(0, 0));
  for (int camera = 1; camera < 40; ++camera) bias.compare(camera, 0, {0.01, 0}, 1e-6, at(camera));
  EXPECT_GT(bias.estimate(10).x(), 0.0003);  // camera 0 takes most of what all say
  EXPECT_EQ(bias.estimate(30), Vector2d(0, 0));
}

TEST(CameraBias, CanBeSwitchedOff) {
  CameraBias bias{Params{.bias_sigma = 0}};
  bias.compare(1, 0, {0.01, 0}, 1e-6, at(1));
  bias.advance();
  EXPECT_EQ(bias.applied(1), Vector2d(0, 0));
}

}  // namespace
}  // namespace tracker
