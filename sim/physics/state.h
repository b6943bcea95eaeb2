#pragma once

#include <array>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/world/robot_command.h"

namespace physics {

/// Where a body is, bit for bit as the collision engine has it.
struct BodyPose {
  std::array<float, 3> origin{};  ///< [m] centre of mass
  std::array<float, 9> basis{};   ///< rotation matrix, row by row
  bool operator==(const BodyPose&) const = default;
};

/// Everything of one robot that changes while it plays.
struct RobotMemory {
  bool present = false;
  world::RobotCommand command;
  int recharging = 0;      ///< substeps until the kicker is ready
  int letting_go = 0;      ///< substeps for which the dribbler leaves a kicked ball alone
  int holding = 0;         ///< substeps for which the present capture of the ball still counts as the same
  int kicks = 0;           ///< fired in this game, misfires too
  int captures = 0;        ///< of the ball by the dribbler in this game
  double grip_factor = 1;  ///< of the present capture
};

/// Everything that changes in a World, as plain values; what does not change is the model's: field, robots,
/// parameters, seed (from which every actuator error follows).
///
/// Bullet's contact caches are no part of it: a restored contact starts without them.
struct State {
  struct Robot {
    RobotMemory memory;
    BodyPose pose;                                       ///< of a robot that is present
    world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s]
    double angular_velocity = 0;                         ///< [rad/s]
  };
  truth::Ball ball;
  BodyPose ball_pose;
  std::vector<Robot> robots;  ///< as given to the World's constructor
};

}  // namespace physics
