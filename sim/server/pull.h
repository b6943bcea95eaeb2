#pragma once

#include "sim/truth/truth.h"
#include "sim/world/geometry.h"

namespace server {

/// Where a body is dragged to ("by force").
struct RobotPull {
  world::Vector2d position = world::Vector2d::Zero();  ///< [m]
  double orientation = 0;                              ///< [rad]
};

/// The motion for the next tick of a ball that is dragged to `target` [m].
///
/// It heads for the target at 5 times the distance a second, at most 3 m/s,
/// and changes its velocity by at most 20 m/s^2: ours, quick and without a jolt. On the ground it rolls;
/// off the ground gravity is balanced.
truth::Ball pulled(truth::Ball ball, const world::Vector3d& target, double ball_radius);

/// The same for a robot; it turns at 8 times the difference a second, at most 10 rad/s.
truth::Robot pulled(truth::Robot robot, const RobotPull& target);

/// The spin of a ball that rolls without sliding at this velocity [rad/s].
world::Vector3d rolling_spin(const world::Vector3d& velocity, double ball_radius);

}  // namespace server
