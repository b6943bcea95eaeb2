#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/geometry.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace truth {

struct Ball {
  /// [m] centre; z is the height of the centre above the carpet
  world::Vector3d position = world::Vector3d::Zero();
  world::Vector3d velocity = world::Vector3d::Zero();  ///< [m/s]
  world::Vector3d spin = world::Vector3d::Zero();      ///< [rad/s]
};

struct Robot {
  world::RobotId id;
  world::Vector2d position = world::Vector2d::Zero();  ///< [m]
  double orientation = 0;                              ///< [rad]
  world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;                         ///< [rad/s]
  bool ball_contact = false;                           ///< the break beam: ball at the dribbler
};

/// Ball and robot touched during one substep.
struct Contact {
  world::Time time;
  world::RobotId robot;
  world::Vector3d point = world::Vector3d::Zero();  ///< [m] ball centre
  double impulse = 0;                               ///< [N s]
};

/// A robot fired its kicker at the ball.
struct Kick {
  world::Time time;
  world::RobotId robot;
  world::Vector3d position = world::Vector3d::Zero();  ///< [m] ball centre
  world::Vector3d velocity = world::Vector3d::Zero();  ///< [m/s] of the ball after it
};

/// What really happened in one tick; known to the simulator and the judge only.
struct Frame {
  std::int64_t tick = 0;
  world::Time time;
  Ball ball;
  std::vector<Robot> robots;  ///< sorted by id
  std::vector<Contact> contacts;
  std::vector<Kick> kicks;
};

}  // namespace truth
