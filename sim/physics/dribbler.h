#pragma once

#include "sim/physics/kicker.h"
#include "sim/physics/params.h"

namespace physics {

/// Share of the full grip at a dribbler speed [rad/s]: 0 when it stands or turns
/// outward, 1 from full_speed on.
double grip(double dribbler_speed, const DribblerParams& params);

/// Change of the ball's velocity by the dribbler in one substep [m/s], in the robot's frame.
///
/// Wanted is the velocity that keeps the ball at the front's centre: the bar's own at the end of the substep,
/// plus gain times the distance to go. The change towards it is bounded by pull (towards the robot) and drag
/// (sideways) times `grip`; pushing the ball away is left to the contact. A bound that is too small for the
/// robot's turn or braking lets the ball slip, and out of reach it is lost.
///
/// @param relative_velocity_local  [m/s] ball minus front centre (after this substep's drive), robot's frame
world::Vector2d dribbler_push(const BallLocal& ball, const world::Vector2d& relative_velocity_local,
                              const world::RobotSpecs& specs, double grip, double ball_radius,
                              double duration, const DribblerParams& params);

/// Spin [rad/s] of a held ball after `duration` seconds: the bar turns it towards backspin at the bar's own
/// surface speed (its fastest at most), at most by spin_up, and takes away any other spin.
///
/// Backspin is about the robot's left axis, negative: the ball's top moves towards the robot. Let go, the
/// ball slides back under the carpet's friction until it rolls: at rest, at 2/7 of the surface speed.
world::Vector3d dribbled_spin(const world::Vector3d& spin, const world::Vector2d& forward,
                              double dribbler_speed, double ball_radius, double duration,
                              const DribblerParams& params);

}  // namespace physics
