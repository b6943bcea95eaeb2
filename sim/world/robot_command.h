#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/geometry.h"

namespace world {

/// What a team asks one of its robots to do until the next command.
struct RobotCommand {
  std::uint8_t number = 0;
  Vector2d velocity_local = Vector2d::Zero();  ///< [m/s] x forward, y left
  double angular_velocity = 0;                 ///< [rad/s]
  double kick_speed = 0;      ///< [m/s] absolute; kicks when positive and the ball is at the dribbler
  double kick_angle = 0;      ///< [rad] elevation, 0 = flat
  double dribbler_speed = 0;  ///< [rad/s]; positive pulls the ball in
};

using TeamCommands = std::vector<RobotCommand>;

}  // namespace world
