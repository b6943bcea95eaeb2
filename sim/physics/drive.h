#pragma once

#include "sim/world/geometry.h"
#include "sim/world/robot_specs.h"

namespace physics {

/// How a robot moves in its plane; field frame.
struct Motion {
  world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;                         ///< [rad/s]
};

/// The motion after `duration` seconds of a drive that tries to reach `target` under the limits of `specs`.
///
/// The target's speed is clamped to max_speed. The velocity changes in a straight line towards it, at
/// max_acceleration when that speeds the robot up, at max_brake when it goes straight against the motion, and
/// between on an ellipse of these two half axes, so there is no jump when turning.
Motion driven(const Motion& now, const Motion& target, const world::RobotSpecs& specs, double duration);

}  // namespace physics
