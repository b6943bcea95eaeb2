#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>

#include "tests/autoref/tracker/running.h"

namespace tracker {
namespace {

// Cameras whose calibration is off by about 10 mm per axis, as the preset `measured` draws it; mean zero.
const std::array<Vector2d, 4> offsets = {
    Vector2d(0.012, -0.004), {-0.009, 0.011}, {-0.010, -0.013}, {0.007, 0.006}};

struct Crossing {
  double jump = 0;        // [m] worst error in the crossing
  double velocity = 0;    // [m/s] worst
  double second = 0;      // [m/s^2] worst half second difference, as touch detection's accel
  double converged = -1;  // [s] when all offsets applied were within 1 mm
};

/// Two robots stand at the halfway line, then a ball of 1.5 m/s rolls across all four cameras.
Crossing cross(bool estimate) {
  Params params;
  if (!estimate) params.bias_sigma = 0;
  Tracker tracker(world::Geometry{}, params);
  Cameras cameras;
  const GroundBall ball{{-1.5, -0.6}, {1.4, 0.55}, false};
  const std::vector<Scene::Robot> robots = {{{Team::Yellow, 1}, {-0.15, 0.1}, 0},
                                            {{Team::Blue, 1}, {0.15, -1.2}, 3},
                                            {{Team::Blue, 2}, {-0.1, 1.4}, 3},
                                            {{Team::Yellow, 2}, {-1.4, 0.2}, 0}};
  Crossing result;
  std::vector<Vector2d> last;
  for (std::int64_t tick = 1; tick <= 220; ++tick) {
    auto images = cameras.images(tick, [&](double t) {
      return Scene{t > 1.5 ? ball.position(t - 1.5) : ball.start, robots};
    });
    for (auto& image : images) {
      const Vector2d& offset = offsets[static_cast<std::size_t>(image.camera)];
      for (auto& shown : image.balls) shown.position += offset;
      for (auto& shown : image.robots) shown.position += offset;
    }
    const world::TrackedFrame* frame = tracker.update(images);
    double worst = 0;
    for (int camera = 0; camera < 4; ++camera) {
      worst = std::max(worst,
                       (tracker.bias().applied(camera) - offsets[static_cast<std::size_t>(camera)]).norm());
    }
    if (worst < 0.001 && result.converged < 0) result.converged = world::seconds(frame->time);
    if (tick < 100) continue;
    const double t = world::seconds(frame->time);
    const Vector2d now = frame->ball->position.head<2>();
    result.jump = std::max(result.jump, (now - ball.position(t - 1.5)).norm());
    result.velocity =
        std::max(result.velocity, (frame->ball->velocity.head<2>() - ball.velocity(t - 1.5)).norm());
    last.push_back(now);
    if (last.size() < 3) continue;
    const std::size_t n = last.size();
    const double second = (last[n - 2] - (last[n - 1] + last[n - 3]) / 2).norm() * 3600;
    result.second = std::max(result.second, second);
  }
  return result;
}

TEST(Seam, IsNoJumpOnceTheOffsetsAreKnown) {
  const Crossing before = cross(false);
  const Crossing after = cross(true);
  std::cout << "seam, without and with offsets estimated: worst position error " << 1000 * before.jump
            << " / " << 1000 * after.jump << " mm, velocity " << before.velocity << " / " << after.velocity
            << " m/s, half second difference " << before.second << " / " << after.second
            << " m/s^2; offsets within 1 mm after " << after.converged << " s\n";
  EXPECT_GT(before.jump, 0.010);  // the offsets themselves
  EXPECT_GT(before.second, 5.0);  // far above touch detection's threshold of 2
  EXPECT_LT(after.jump, 0.003);   // 1 mm of offset, and noise as without offsets (HandsOver..., 2.5 mm)
  EXPECT_LT(after.velocity, 0.15);
  EXPECT_LT(after.second, 3.5);  // noise alone: 0.5 mm sightings make 0.4 mm x 1.2 x 3600 = 1.8, worst of 120
  EXPECT_GT(after.converged, 0);
  EXPECT_LT(after.converged, 1.5);  // 12 mm at 0.2 mm a frame is 1 s
}

TEST(Seam, AnOffsetIsLearntWithoutMovingAnything) {
  // A robot at rest in the overlap while the offsets are learnt: what is applied walks 12 mm/s at most.
  Tracker tracker{world::Geometry{}};
  Cameras cameras;
  for (std::int64_t tick = 1; tick <= 120; ++tick) {
    auto images = cameras.images(tick, standing(Vector2d(1, 1), {{yellow_3, {0, 1}, 0}}));
    for (auto& image : images) {
      for (auto& shown : image.robots) shown.position += offsets[static_cast<std::size_t>(image.camera)];
    }
    const world::TrackedFrame* frame = tracker.update(images);
    if (tick < 8) continue;
    // Two cameras 4 ms apart that differ by up to 8 mm are both believed: 25 mm over a frame's base is 1 m/s
    // at first; once they agree nothing is left but noise.
    if (tick > 70) {
      EXPECT_LT(frame->robots.at(0).velocity.norm(), 0.15) << tick;
    }
  }
  EXPECT_LT((tracker.bias().applied(2) - tracker.bias().applied(3) - (offsets[2] - offsets[3])).norm(),
            0.001);
}

}  // namespace
}  // namespace tracker
