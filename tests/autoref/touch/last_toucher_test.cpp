#include "autoref/touch/last_toucher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <optional>

#include "autoref/tracker/tracker.h"
#include "experiments/judge/true_touches.h"
#include "sim/engine/engine.h"
#include "sim/engine/realism.h"

namespace touch {
namespace {

constexpr world::RobotId yellow_0{world::Team::Yellow, 0};
constexpr world::RobotId blue_0{world::Team::Blue, 0};

struct Outcome {
  std::optional<world::RobotId> truth;
  std::optional<world::Touch> said;
};

/// Simulates a ball that comes along +x at `speed` and meets, or misses by `gap` [m], a robot whose back it
/// sees, with another robot a metre away; tells who touched it in truth and who the detector says it was.
Outcome passage(double speed, double gap, bool yellow_stands_there, std::uint64_t seed, double mirror = 1) {
  engine::Model model;
  model.seed = seed;
  model.realism = engine::realism("measured");
  for (const world::Team team : world::both_teams) {
    model.robots[team] = engine::standard_robots(team, {0}, 1, model.realism.robots);
  }
  engine::Engine engine(model);
  const world::RobotId near = yellow_stands_there ? yellow_0 : blue_0;
  const world::RobotId far = yellow_stands_there ? blue_0 : yellow_0;
  engine.put_robot(near, {1.2, mirror * (1.0 - 0.1115 - gap)}, mirror * 1.2);
  engine.put_robot(far, {2.5, mirror * 2.3}, 0);
  truth::Ball ball;
  ball.position = {0.8 - 0.3 * speed, mirror * 1.0, 0.0215};
  ball.velocity = {speed, 0, 0};
  engine.put_ball(ball);

  tracker::Tracker tracker(model.geometry);
  LastToucher detector(model.geometry);
  judge::TrueTouches touches;
  std::vector<world::Touch> found;
  Outcome outcome;
  const int ticks = 90;  // the ball arrives after 0.3 to 0.6 s
  for (int n = 0; n < ticks; ++n) {
    engine.step({});
    touches.add(engine.truth(), true);
    const world::TrackedFrame* frame = tracker.update(engine.detections());
    if (!frame) continue;
    found.clear();
    detector.update(*frame, engine.detections(), found);
    for (const world::Touch& touch : found) outcome.said = touch;
  }
  if (const auto* last = touches.last_at(engine.time())) outcome.truth = touches[last->touch].robot;
  return outcome;
}

std::optional<world::RobotId> robot(const std::optional<world::Touch>& touch) {
  if (!touch || touch->probability < 0.5) return std::nullopt;
  return touch->robot;
}

TEST(LastToucher, IsRightAboutBallsThatHitOrMiss) {
  // From full hits (-60 mm) to misses by 40 mm, 1 to 6 m/s, both colours, both sides. Grazes are hard: the
  // bound is 9 of 10; what was found is printed for the notes (results/published/2026-11-22-tuning).
  int right = 0;
  int all = 0;
  std::uint64_t seed = 1;
  for (const double speed : {1.0, 2.0, 4.0, 6.0}) {
    for (const double gap : {-0.06, -0.03, -0.01, 0.01, 0.02, 0.04}) {
      for (const bool yellow : {true, false}) {
        const Outcome outcome = passage(speed, gap, yellow, seed, seed % 3 == 0 ? -1 : 1);
        ++seed;
        ++all;
        const bool good = robot(outcome.said) == outcome.truth;
        right += good;
        if (!good)
          std::cout << "wrong: " << speed << " m/s, gap " << 1000 * gap << " mm, "
                    << (outcome.truth ? "touched" : "free") << ", said "
                    << (outcome.said ? outcome.said->probability : 0) << "\n";
      }
    }
  }
  std::cout << "passages right: " << right << " of " << all << "\n";
  EXPECT_GE(right, all * 9 / 10);
}

TEST(LastToucher, TellsTimePlaceAndProbabilityOfABounce) {
  const Outcome outcome = passage(3, -0.06, true, 4);
  ASSERT_TRUE(outcome.said);
  EXPECT_EQ(outcome.said->robot, yellow_0);
  EXPECT_GT(outcome.said->probability, 0.95);
  EXPECT_LT((outcome.said->position - Vector2d(1.11, 1.0)).norm(),
            0.05);  // where ball and hull meet, and biases
}

TEST(LastToucher, SaysNothingWithoutABall) {
  LastToucher detector{world::Geometry{}};
  std::vector<world::Touch> found;
  world::TrackedFrame frame;
  frame.time = world::tick_time(1);
  detector.update(frame, {}, found);
  EXPECT_TRUE(found.empty());
}

TEST(LastToucher, MakesDoWithTrackedFrames) {
  // No images: a ball comes along x to the hull and bounces back.
  LastToucher detector{world::Geometry{}};
  std::vector<world::Touch> found;
  std::optional<world::Touch> said;
  for (int k = 0; k < 30; ++k) {
    world::TrackedFrame frame;
    frame.time = world::tick_time(k + 1);
    const double x = 0.1115 + 0.05 * std::abs(15 - k);
    frame.ball = world::TrackedBall{.position = {x, 0, 0}, .observed = true};
    frame.robots = {{.id = blue_0, .orientation = 3.14, .observed = true}};
    found.clear();
    detector.update(frame, {}, found);
    if (!said && !found.empty()) said = found.back();
  }
  ASSERT_TRUE(said);
  EXPECT_EQ(said->robot, blue_0);
  EXPECT_NEAR(world::seconds(said->time), 16 * world::tick_length, 1.5 * world::tick_length);
}

/// The probability that blue touched last a ball that yellow kicked to it and that is hidden there from 0.1 m
/// before the touch line until it is well outside.
/// @param heard  whether the paper's three name blue
double hidden_over_the_line(bool heard) {
  LastToucher detector{world::Geometry{}};
  const double line = world::Field{}.half_width();
  const std::optional<world::Touch> named = world::Touch{blue_0, world::tick_time(60), {0, line}};
  std::vector<world::Touch> found;
  double blue = 0;
  for (int k = 0; k < 90; ++k) {
    world::TrackedFrame frame;
    frame.time = world::tick_time(k + 1);
    const double y = line - 1 + (k < 30 ? 0 : 0.03 * (k - 30));
    frame.ball = world::TrackedBall{.position = {0, y, 0}, .observed = y < line - 0.1};
    if (k > 30) frame.ball->velocity.y() = 1.8;
    frame.robots = {{.id = yellow_0, .position = {0, line - 1.0945}, .orientation = 1.5708, .observed = true},
                    {.id = blue_0, .position = {0.09, y + 0.06}, .orientation = 0, .observed = true}};
    found.clear();
    detector.update(frame, {}, heard && k >= 60 ? named : std::nullopt, found);
    for (const world::Touch& touch : found) {
      blue = touch.robot == blue_0 ? touch.probability : touch.rival == blue_0 ? 1 - touch.probability : 0;
    }
  }
  return blue;
}

// It is called out when it was hidden there for a while, so this is the last time to look back.
TEST(LastToucher, HearsTheThreeAboutABallThatIsHiddenOutside) {
  EXPECT_GT(hidden_over_the_line(true), hidden_over_the_line(false));
}

}  // namespace
}  // namespace touch
