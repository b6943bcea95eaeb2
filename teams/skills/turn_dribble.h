#pragma once

#include "teams/kit/view.h"
#include "teams/skills/order.h"

namespace skills {

/// How the ball is carried while a robot turns: it runs on a circle of that radius, and the heading makes the
/// angle phi with its direction of travel, towards the inside.
///
/// phi = 90 degrees   the ball lies between robot and middle: the robot circles round both
/// phi = -90 degrees  the robot looks outwards: with radius 0.095 m it turns in place, with radius 0 it
///                    circles round the ball
struct TurnCircle {
  double rate = 0;    ///< [rad/s]
  double radius = 0;  ///< [m]
  double phi = 0;     ///< [rad]
};

/// The fastest circle on which the ball stays at the dribbler, for turns at `rate` [rad/s]: phi(rate) and its
/// radius by a table, measured in our simulator.
///
/// Source  `turn_study` (tests/teams/support), see README; form: reference "football", 2.10
TurnCircle turn_circle(double rate);

/// The fastest rate of that table [rad/s].
double fastest_turn();

/// Velocity of the robot's centre [m/s] that carries the ball on the circle while the robot turns at `rate`
/// [rad/s, counter-clockwise].
Vector2d carrying_velocity(const kit::Robot& robot, const TurnCircle& circle, double rate,
                           double ball_radius);

/// Turns to `heading` [rad] with the ball at the dribbler, which runs on that circle, and drifts with `drift`
/// [m/s] meanwhile.
Order turn_with_ball(const kit::View& view, const kit::Robot& robot, double heading, const TurnCircle& circle,
                     const Vector2d& drift = Vector2d::Zero());

/// Turns to `direction` [rad] with the ball, sheltering it, and kicks when the heading is within `tolerance`
/// and the turn nearly at rest.
///
/// @param rate  [rad/s] at most; beyond the table's last row that one is used
Order turn_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                    double kick_angle, double tolerance, double rate = 8);

/// How long a turn by `angle` [rad] with the ball takes [s].
double turn_time(const kit::Robot& robot, double angle, double rate = 8);

/// Where to drift while turning: straight away from the nearest opponent, at most 0.3 m/s, less the farther
/// it is; nothing beyond 0.6 m.
///
/// Source  reference "football", 2.10 (shielding); 0.6 m is ours
Vector2d shielding_drift(const kit::View& view, const kit::Robot& robot);

}  // namespace skills
