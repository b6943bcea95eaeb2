#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "autoref/tracker/tracker.h"
#include "sim/engine/engine.h"
#include "sim/world/random.h"

namespace tracker {
namespace {

using world::Vector3d;

constexpr world::RobotId kicker{world::Team::Yellow, 3};
constexpr std::array<int, 6> asked = {5, 6, 8, 10, 15, 20};  // frames after the kick

struct Result {
  int kicks = 0;
  std::array<int, 41> said{};     // in the air, by frame
  std::array<int, 41> doubted{};  // that it may be
  int ever = 0;
  double landing = 0, highest = 0, launch = 0;  // squares
  int landed = 0;
  std::array<double, 41> beside{}, above{};  // squares of errors in the air, horizontal and of the height
  std::array<int, 41> flying{};
  double share(int frame) const { return static_cast<double>(said[static_cast<std::size_t>(frame)]) / kicks; }
  double doubt(int frame) const {
    return static_cast<double>(doubted[static_cast<std::size_t>(frame)]) / kicks;
  }
};

/// Kicks by a robot that comes to a ball at rest, as the engine's cameras see them: chips of 2.5 to 5.5 m/s
/// and 35 to 55 degrees, or flat ones of 1.5 to 7.5 m/s, anywhere in the middle of the field, in all
/// directions (the distribution of football.md 3.3).
Result play(const char* preset, bool chips, int kicks) {
  engine::Model model;
  model.realism = engine::realism(preset);
  model.robots.yellow = engine::standard_robots(kicker.team, {kicker.number});
  model.seed = 5;
  engine::Engine engine(model);
  Tracker tracker(engine.model().geometry);
  world::RandomStream random(9, "chips");
  Result result;
  for (int n = 0; n < kicks; ++n) {
    const double heading = 2 * std::numbers::pi * random.uniform();
    const Vector2d along = world::direction(heading);
    const Vector2d spot(6.5 * random.uniform() - 3.25, 4 * random.uniform() - 2);
    const double speed = chips ? 2.5 + 3 * random.uniform() : 1.5 + 6 * random.uniform();
    const double rise = chips ? (35 + 20 * random.uniform()) * std::numbers::pi / 180 : 0;
    engine.put_robot(kicker, spot - 0.5 * along, heading);
    engine.place_ball(spot);
    for (int tick = 0; tick < 30 + n % 4; ++tick) {
      if (tick == 10) engine.put_robot(kicker, spot - 0.0975 * along, heading);
      engine.step({});
      tracker.update(engine.detections());
    }
    truth::Ball ball = engine.truth().ball;
    ball.velocity << speed * std::cos(rise) * along, speed * std::sin(rise);
    ball.spin.setZero();
    engine.put_ball(ball);
    const double start = world::seconds(engine.time());
    const double duration = 2 * ball.velocity.z() / 9.81;
    const Vector2d landing = ball.position.head<2>() + ball.velocity.head<2>() * duration;
    const double highest = ball.velocity.z() * ball.velocity.z() / (2 * 9.81);

    ++result.kicks;
    bool ever = false, landed = false;
    for (int tick = 0; tick < 45; ++tick) {
      engine.step({});
      const world::TrackedFrame* frame = tracker.update(engine.detections());
      if (!frame || !frame->ball) continue;
      const double since = world::seconds(frame->time) - start;
      const auto index = static_cast<std::size_t>(std::max(0.0, std::round(since * 60)));
      const world::TrackedBall& seen = *frame->ball;
      const bool flies = seen.airborne > 0.5;
      EXPECT_EQ(flies, seen.flight.has_value());
      if (since < 0 || index >= result.said.size()) continue;
      EXPECT_FALSE(flies && seen.may_fly);
      result.said[index] += flies;
      result.doubted[index] += seen.may_fly;
      ever = ever || flies;
      if (flies && since < duration) {
        const Vector2d place = ball.position.head<2>() + ball.velocity.head<2>() * since;
        const double height = ball.velocity.z() * since - 9.81 / 2 * since * since;
        ++result.flying[index];
        result.beside[index] += (seen.position.head<2>() - place).squaredNorm();
        result.above[index] += (seen.position.z() - height) * (seen.position.z() - height);
      }
      if (!flies || landed || since < duration - 0.04 || since > duration || !(duration > 0.04)) continue;
      // Beyond the walls it lands elsewhere: it meets them in the air, and goes on flying.
      if (world::distance_outside_lines(engine.model().geometry.field, landing) > 0.5) continue;
      landed = true;
      ++result.landed;
      const double rest = (seen.velocity.z() + std::sqrt(seen.velocity.z() * seen.velocity.z() +
                                                         2 * 9.81 * std::max(0.0, seen.position.z()))) /
                          9.81;
      result.landing += (seen.position.head<2>() + seen.velocity.head<2>() * rest - landing).squaredNorm();
      result.highest += (seen.flight->highest - highest) * (seen.flight->highest - highest);
      result.launch += (seen.flight->launch_velocity - ball.velocity).squaredNorm();
    }
    result.ever += ever;
  }
  return result;
}

void tell(const char* preset, const char* what, const Result& result) {
  std::printf("%s, %d %s: in the air by frame", preset, result.kicks, what);
  for (const int frame : asked) std::printf(" %d: %.3f", frame, result.share(frame));
  std::printf("; ever %.3f; may be:", static_cast<double>(result.ever) / result.kicks);
  for (const int frame : {1, 2, 3, 4, 5, 6, 8, 10}) std::printf(" %d: %.3f", frame, result.doubt(frame));
  if (result.landed > 0) {
    std::printf("; rms of landing point %.1f mm, greatest height %.1f mm, launch velocity %.3f m/s (%d)",
                1000 * std::sqrt(result.landing / result.landed),
                1000 * std::sqrt(result.highest / result.landed), std::sqrt(result.launch / result.landed),
                result.landed);
  }
  std::printf("\n");
  for (const std::size_t frame : {8, 10, 15, 20}) {
    if (result.flying[frame] == 0) continue;
    std::printf("  after %zu frames: place %.0f mm, height %.0f mm\n", frame,
                1000 * std::sqrt(result.beside[frame] / result.flying[frame]),
                1000 * std::sqrt(result.above[frame] / result.flying[frame]));
  }
}

// The reference (football.md 3.3, noise 1.4 mm, kick point known to 15 mm) has 0.91 after 8 frames at 1 %
// false positives and 25 mm for the landing point after 15; these sensors have offsets, occlusion and several
// cameras as well.
TEST(Chips, AreFoundAndFlatKicksAreNotWithMeasuredSensors) {
  const Result chips = play("measured", true, 200);
  const Result flat = play("measured", false, 200);
  tell("measured", "chips", chips);
  tell("measured", "flat kicks", flat);
  EXPECT_GT(chips.share(8), 0.91);
  EXPECT_GT(chips.share(15), 0.93);
  EXPECT_LT(flat.ever, 3);  // 1 % of 200, and one more by chance
  for (const int frame : {3, 4, 5}) EXPECT_GT(chips.doubt(frame) + chips.share(frame), 0.9) << frame;
  EXPECT_LT(flat.doubt(8), 0.05);
  EXPECT_LT(std::sqrt(chips.landing / chips.landed), 0.025);
  EXPECT_LT(std::sqrt(chips.highest / chips.landed), 0.05);
}

TEST(Chips, AreMostlyFoundWithHarshSensors) {
  const Result chips = play("harsh", true, 200);
  const Result flat = play("harsh", false, 200);
  tell("harsh", "chips", chips);
  tell("harsh", "flat kicks", flat);
  EXPECT_GT(chips.share(8), 0.75);
  EXPECT_GT(chips.share(15), 0.88);
  EXPECT_LT(flat.share(8), 0.02);
  EXPECT_LT(flat.ever, 16);  // 8 %: one of the first frames
  EXPECT_LT(std::sqrt(chips.landing / chips.landed), 0.08);
}

TEST(Chips, AreNotLookedForWithoutTheModelOrWithoutCameras) {
  engine::Model model;
  model.realism = engine::realism("measured");
  model.robots.yellow = engine::standard_robots(kicker.team, {kicker.number});
  for (const bool cameras : {false, true}) {
    engine::Engine engine(model);
    world::Geometry geometry = engine.model().geometry;
    if (!cameras) geometry.cameras.clear();
    Tracker tracker(geometry, {.ball_in_space = !cameras});
    engine.put_robot(kicker, {-0.9025, 1}, std::numbers::pi);  // does not hide the ball
    engine.place_ball({-1, 1});
    for (int tick = 0; tick < 30; ++tick) {
      engine.step({});
      tracker.update(engine.detections());
    }
    truth::Ball ball = engine.truth().ball;
    ball.velocity = {-3, 1, 3};
    engine.put_ball(ball);
    for (int tick = 0; tick < 30; ++tick) {
      engine.step({});
      tracker.update(engine.detections());
      ASSERT_TRUE(tracker.frame().ball);
      EXPECT_EQ(tracker.frame().ball->airborne, 0);
      EXPECT_EQ(tracker.frame().ball->position.z(), 0);
      EXPECT_FALSE(tracker.frame().ball->flight);
    }
  }
}

}  // namespace
}  // namespace tracker
