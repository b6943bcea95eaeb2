#pragma once

#include "teams/kit/view.h"

namespace support {

/// A view on the standard field while the game runs, with the ball there and no robots.
inline kit::View running(const world::Vector2d& ball,
                         const world::Vector2d& velocity = world::Vector2d::Zero()) {
  kit::View view;
  view.tick = 1000;
  view.time = 1000.0 / world::ticks_per_second;
  view.ball.known = true;
  view.ball.position = ball;
  view.ball.velocity = velocity;
  view.ball.rolls_below = 10;  // rolls
  view.game.phase = kit::Phase::Running;
  view.own.reserve(16);
  view.opponents.reserve(16);
  return view;
}

/// Adds a robot at rest; numbers in rising order.
inline kit::Robot& put(std::vector<kit::Robot>& robots, int number, const world::Vector2d& position,
                       double orientation = 0) {
  kit::Robot robot;
  robot.number = static_cast<std::uint8_t>(number);
  robot.position = position;
  robot.orientation = orientation;
  robots.push_back(robot);
  return robots.back();
}

}  // namespace support
