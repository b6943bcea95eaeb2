#pragma once

#include <optional>

#include "sim/physics/actuators.h"
#include "sim/physics/params.h"
#include "sim/world/geometry.h"
#include "sim/world/robot_command.h"
#include "sim/world/robot_specs.h"

namespace physics {

/// Where the ball is as a robot sees it.
struct BallLocal {
  world::Vector2d position = world::Vector2d::Zero();  ///< [m] robot's frame
  double height = 0;                                   ///< [m] centre above the carpet
};

/// Gap between the flat front and the ball [m]; negative when they overlap.
double gap_to_front(const BallLocal& ball, const world::RobotSpecs& specs, double ball_radius);

/// The ball is in the box before the flat front: within `reach` [m] of it, between the dribbler's ends,
/// no higher than `highest` [m]. The box begins half a ball inside the front, since fast contacts
/// overlap for a substep.
bool in_front(const BallLocal& ball, const world::RobotSpecs& specs, double ball_radius, double reach,
              double highest);

/// Velocity of the ball after a kick [m/s], field frame; nothing when the command asks for none.
///
/// The absolute speed in space is what was commanded, capped by the specs (flat or chip), with the error's
/// factor and under the cap again. The kicker pushes along the heading, raised by kick_angle, both with their
/// errors; a chip stays a chip. The robot's forward speed is not added: the plunger is faster
/// than any robot and its speed is what was asked for. What the ball has of the robot's sideways motion it
/// keeps, which turns the direction but not the speed.
///
/// @param forward  unit vector of the heading, field frame
/// @param carried  [m/s] velocity of the robot's front centre, field frame
std::optional<world::Vector3d> kicked_velocity(const world::RobotCommand& command,
                                               const world::RobotSpecs& specs, const KickerParams& params,
                                               const world::Vector2d& forward, const world::Vector2d& carried,
                                               const KickError& error = {});

}  // namespace physics
