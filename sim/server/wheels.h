#pragma once

#include <optional>

#include "sim/wire/robot_control.h"
#include "sim/world/geometry.h"

namespace server {

/// A robot's motion in its own frame.
struct LocalMotion {
  world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s] x forward, y left
  double angular_velocity = 0;                         ///< [rad/s]
};

/// How a robot moves whose wheels turn at these speeds.
///
/// A wheel at the angle a, clockwise from forward, on the circle of radius `radius` [m] has the rim speed
///
///   s = vx sin a + vy cos a + radius * w
///
/// Four wheels give four equations for three unknowns: when they disagree, wheels slip, and the answer is the
/// least squares one.
///
/// @returns  nothing when the wheels cannot say where to go, e.g. all four at one angle
std::optional<LocalMotion> motion(const wire::WheelAngles& angles, const wire::WheelSpeeds& speeds,
                                  double radius);

}  // namespace server
