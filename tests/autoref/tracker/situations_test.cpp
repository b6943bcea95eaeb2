#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "autoref/tracker/tracker.h"
#include "teams/reference/reference_team.h"
#include "tests/teams/support/arena.h"

namespace tracker {
namespace {

using world::Vector3d;

struct Errors {
  int count = 0;
  double position = 0, velocity = 0;  // squares
  int beyond = 0;                     // three sigmas and 3 mm
  std::vector<double> positions;
  void add(double p, double v, double sigma) {
    ++count;
    position += p * p;
    velocity += v * v;
    beyond += p > 3 * sigma + 0.003;
    positions.push_back(p);
  }
  /// Of the best share of the frames: a false ball that was believed for a moment is no matter of accuracy.
  double position_rms_of(double share) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(positions.size()));
    std::nth_element(positions.begin(), positions.begin() + static_cast<std::ptrdiff_t>(kept),
                     positions.end());
    double sum = 0;
    for (std::size_t i = 0; i < kept; ++i) sum += positions[i] * positions[i];
    return std::sqrt(sum / static_cast<double>(kept));
  }
  double position_rms() const { return std::sqrt(position / count); }
  double velocity_rms() const { return std::sqrt(velocity / count); }
};
using Table = std::map<std::string, Errors>;

/// What the ball is doing, by truth and by whether it is seen.
std::string situation(const truth::Frame& truth, bool seen, double ball_radius) {
  double gap = 10;
  bool held = false;
  for (const truth::Robot& robot : truth.robots) {
    gap = std::min(gap, (robot.position - truth.ball.position.head<2>()).norm() - 0.09 - ball_radius);
    held = held || robot.ball_contact;
  }
  if (truth.ball.position.z() - ball_radius > 0.03) return "ball in the air";
  if (!seen) return gap < 0.1 ? "ball hidden by a robot" : "ball lost in a burst";
  if (held) return "ball at a dribbler";
  if (gap < 0.05) return "ball near a robot";
  return truth.ball.velocity.norm() < 0.05 ? "ball at rest" : "ball rolling or sliding";
}

/// How far from truth a tracker is in a game of the reference team against itself. Cameras have an offset in
/// common that nobody can see: it is taken from truth.
Table play(const char* preset, std::uint64_t seed, double half) {
  support::Side side;
  side.make = [](const kit::Setup& setup) {
    return std::make_unique<reference::ReferenceTeam>(setup, reference::Parameters{}, false);
  };
  support::Arena arena(side, side, seed, preset);
  arena.start_referee(world::from_seconds(half));
  const world::Geometry& geometry = arena.engine().model().geometry;
  Tracker tracker(geometry);

  struct Moment {
    truth::Frame truth;
    world::TrackedFrame tracked;
  };
  std::deque<truth::Frame> past;
  std::vector<Moment> moments;
  std::map<int, std::pair<Vector2d, int>> offsets;  // sum and number, by camera
  int since_reset = 0;
  while (arena.tick()) {
    past.push_back(arena.engine().truth());
    if (past.size() > 5) past.pop_front();
    const std::size_t n = past.size();
    const bool reset = n > 1 && (past[n - 1].ball.position - past[n - 2].ball.position).norm() > 0.2;
    since_reset = reset ? 0 : since_reset + 1;
    const world::TrackedFrame* frame = tracker.update(arena.engine().detections());
    if (!frame || since_reset < 15) continue;
    for (const truth::Frame& then : past) {
      if (std::abs(world::seconds(then.time - frame->time)) > 1e-4) continue;
      moments.push_back({then, *frame});
      for (const world::Detection& image : arena.engine().detections()) {
        if (image.t_capture != frame->time) continue;
        for (const world::DetectedRobot& robot : image.robots) {
          for (const truth::Robot& real : then.robots) {
            if (!robot.number || real.id != world::RobotId{robot.team, *robot.number}) continue;
            const Vector2d off = robot.position - real.position;
            auto& [sum, count] = offsets.try_emplace(image.camera, Vector2d(0, 0), 0).first->second;
            if (off.norm() < 0.08) sum += off, ++count;
          }
        }
      }
    }
  }
  // Only cameras that capture last in a tick are compared with truth here; the others by what the tracker
  // says of their difference.
  Vector2d common = Vector2d::Zero();
  for (const auto& [camera, offset] : offsets) {
    common += (offset.first / offset.second - tracker.bias().estimate(camera)) /
              static_cast<double>(offsets.size());
  }

  Table table;
  for (const Moment& moment : moments) {
    if (moment.tracked.ball) {
      const world::TrackedBall& ball = *moment.tracked.ball;
      const Vector3d off = ball.position - moment.truth.ball.position;
      table[situation(moment.truth, ball.observed, geometry.field.ball_radius)].add(
          (off.head<2>() - common).norm(), (ball.velocity - moment.truth.ball.velocity).head<2>().norm(),
          ball.sigma);
    }
    for (const world::TrackedRobot& robot : moment.tracked.robots) {
      for (const truth::Robot& real : moment.truth.robots) {
        if (real.id != robot.id) continue;
        table[robot.observed ? "robot" : "robot not seen"].add(
            (robot.position - real.position - common).norm(), (robot.velocity - real.velocity).norm(), 1);
      }
    }
  }
  for (const auto& [name, errors] : table) {
    std::printf("%-9s %-24s %7d  position %6.1f mm  velocity %.3f m/s  beyond three sigmas %.1f %%\n", preset,
                name.c_str(), errors.count, 1000 * errors.position_rms(), errors.velocity_rms(),
                100.0 * errors.beyond / errors.count);
  }
  return table;
}

// Bounds are half again what was measured (README, Measured), so that a change for the worse shows. How far
// a hidden ball is off depends on the few long hidings of a game, hence the middle of three games.
TEST(Situations, ErrorsAgainstTruthWithMeasuredSensors) {
  std::array<double, 3> hidden{};
  for (std::size_t game = 0; game < hidden.size(); ++game) {
    Table table = play("measured", 7 + game, 100);
    EXPECT_LT(table["robot"].position_rms(), 0.002);
    EXPECT_LT(table["robot"].velocity_rms(), 0.09);
    EXPECT_LT(table["ball at rest"].position_rms(), 0.004);
    // A kick is believed some frames after it: in 2 % of the frames the ball is elsewhere.
    EXPECT_LT(table["ball rolling or sliding"].position_rms_of(0.98), 0.012);
    EXPECT_LT(table["ball at a dribbler"].position_rms(), 0.015);
    hidden[game] = table["ball hidden by a robot"].position_rms();
  }
  std::ranges::sort(hidden);
  EXPECT_LT(hidden[1], 0.09);
}

// In one game of nine a false ball is believed for seconds while the true one is hidden between robots (0.9 m
// off in a tenth of the hidden frames): the README's limits say so. Which game it is changes with the teams,
// hence the middle of three.
TEST(Situations, ErrorsAgainstTruthWithHarshSensors) {
  std::array<double, 3> hidden{};
  for (std::size_t game = 0; game < hidden.size(); ++game) {
    Table table = play("harsh", 7 + game, 100);
    EXPECT_LT(table["robot"].position_rms(), 0.007);
    EXPECT_LT(table["robot"].velocity_rms(), 0.4);
    // Two false balls a game last 0.3 s each and may be believed while the ball is lost: 2 % of the frames.
    EXPECT_LT(table["ball at rest"].position_rms_of(0.98), 0.012);
    EXPECT_LT(table["ball rolling or sliding"].position_rms_of(0.98), 0.03);
    hidden[game] = table["ball hidden by a robot"].position_rms_of(0.9);
  }
  std::ranges::sort(hidden);
  EXPECT_LT(hidden[1], 0.09);
}

}  // namespace
}  // namespace tracker
