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
/// Limits forward and sideways are the half axes of ellipses in the robot's frame. The target is shortened to
/// the ellipse of speeds. The velocity changes in a straight line towards the target, and the limit is
/// - the ellipse of accelerations when the change speeds the robot up,
/// - the ellipse of brakes when the change goes straight against the motion,
/// - between (on an ellipse of these two) when it goes partly across, so there is no jump when turning.
///
/// A rotation is braked while it shrinks, accelerated while it grows. A reversal within one step counts as
/// braking for all of it.
///
/// @param forward  unit vector of the heading, field frame
Motion driven(const Motion& now, const Motion& target, const world::Vector2d& forward,
              const world::RobotSpecs& specs, double duration);

}  // namespace physics
