#pragma once

#include <vector>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

using namespace std::chrono_literals;

inline constexpr world::RobotId yellow_3{world::Team::Yellow, 3};

inline const world::RuleSet& rules() { return world::rule_set("ssl-2015"); }

/// The ball, seen, and yellow 3 100 mm to its left.
inline world::TrackedFrame frame_at(world::Time time, world::Vector2d ball, bool in_reach = false) {
  world::TrackedFrame frame;
  frame.time = time;
  frame.ball = world::TrackedBall{};
  frame.ball->position << ball, 0.0;
  frame.ball->observed = true;
  world::TrackedRobot robot;
  robot.id = yellow_3;
  robot.position = ball - world::Vector2d{0.1, 0};
  robot.ball_in_reach = in_reach;
  frame.robots.push_back(robot);
  return frame;
}

/// The ball along a straight way, one frame every 10 ms; all events.
inline std::vector<world::GameEvent> along(Detector& detector, world::Vector2d from, world::Vector2d velocity,
                                           int frames, bool in_reach = false, world::Time start = {}) {
  std::vector<world::GameEvent> all;
  for (int i = 0; i <= frames; ++i) {
    world::TrackedFrame frame = frame_at(start + i * 10ms, from + velocity * (i * 0.01), in_reach);
    frame.ball->velocity << velocity, 0.0;
    for (world::GameEvent& event : detector.update(frame, world::GameState{})) all.push_back(event);
  }
  return all;
}

inline double seconds_of(const world::GameEvent& event) { return world::seconds(event.time); }

/// Guards linear in time are interpolated exactly, but for rounding to whole nanoseconds.
inline constexpr double one_rounding = 2e-9;

}  // namespace detectors
