#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "autoref/tracker/tracker.h"
#include "tests/autoref/tracker/synthetic.h"

namespace tracker {

using synthetic::Cameras;
using synthetic::GroundBall;
using synthetic::Motion;
using synthetic::Scene;
using world::RobotId;
using world::Team;

inline constexpr RobotId yellow_3{Team::Yellow, 3};

inline bool is_finite(const world::TrackedFrame& frame) {
  bool finite = !frame.ball || (frame.ball->position.allFinite() && frame.ball->velocity.allFinite());
  for (const world::TrackedRobot& robot : frame.robots) {
    finite = finite && robot.position.allFinite() && robot.velocity.allFinite() &&
             std::isfinite(robot.orientation) && std::isfinite(robot.angular_velocity);
  }
  return finite;
}

/// Feeds ticks first..last of a motion; `each` sees the frame after every tick.
inline void run(Tracker& tracker, Cameras& cameras, std::int64_t first, std::int64_t last,
                const Motion& motion,
                const std::function<void(std::int64_t, const world::TrackedFrame&)>& each = {}) {
  for (std::int64_t tick = first; tick <= last; ++tick) {
    const world::TrackedFrame* frame = tracker.update(cameras.images(tick, motion));
    ASSERT_NE(frame, nullptr);
    ASSERT_TRUE(is_finite(*frame));
    if (each) each(tick, *frame);
  }
}

inline Motion standing(std::optional<Vector2d> ball, std::vector<Scene::Robot> robots = {}) {
  return [=](double) { return Scene{ball, robots}; };
}

/// 6 against 6 in game-like motion round a ball that was kicked.
struct Game {
  explicit Game(std::uint64_t seed, double duration) : ball{{-2, -1}, {3, 1.2}} {
    for (std::uint64_t n = 0; n < 12; ++n) robots.emplace_back(100 * seed + n, duration);
  }
  Scene operator()(double seconds) const {
    Scene scene{ball.position(seconds), {}};
    for (std::uint8_t n = 0; n < 12; ++n) {
      const RobotId id{n < 6 ? Team::Yellow : Team::Blue, static_cast<std::uint8_t>(n % 6)};
      scene.robots.push_back({id, robots[n].position(seconds), robots[n].heading(seconds)});
    }
    return scene;
  }
  GroundBall ball;
  std::vector<synthetic::GameRobot> robots;
};

}  // namespace tracker
