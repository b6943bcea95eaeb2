#pragma once

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/skills/order.h"

namespace skills {

/// Distance from a robot's centre to a ball that lies at its dribbler [m].
double reach_of(const kit::Robot& robot, double ball_radius);

/// Where the centre of a robot stands when the ball lies at its dribbler and it looks along `direction`.
Vector2d behind_ball(const Vector2d& ball, const Vector2d& direction, const kit::Robot& robot,
                     double ball_radius, double gap = 0);

/// Velocity [m/s] on the way round a near ball to the place behind it, seen along `direction` [rad].
///
/// On a circle of hull and ball radius and 30 mm of air, at most as fast as the robot's acceleration holds it
/// on the circle, v^2 = a r; spiralling in over the last 0.3 rad. The ball's own velocity is added.
///
/// Source  radius: reference "football", 2.8 and 2.10
Vector2d orbit_velocity(const kit::Ball& ball, const kit::Robot& robot, double direction, double ball_radius);

/// How long it takes to go round a ball at the dribbler by `angle` [rad], until it could be kicked [s].
double orbit_time(const kit::Robot& robot, double angle, double ball_radius);

/// Gets behind the ball and then drives through it, so that a kick goes along `direction` [rad].
///
/// Far                          goes to a point behind the ball
/// Near it, on the wrong side   circles round it
/// Behind it                    drives straight on, the kicker armed once the heading is within `tolerance`
///                              [rad]
///
/// @param kick_speed  [m/s]; 0: only take the ball
/// Source  reference "football", 2.8 (approach) and the kick gate there
Order approach_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                        double kick_angle, double tolerance);

/// Takes the ball with the dribbler the shortest way: straight at it, looking at it.
Order capture(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model);

/// Lets go of a ball at the dribbler so that it stays where it is: the bar turns just enough to take the
/// backspin out of it, then the robot backs off, `since` [s] after it began.
Order release(const kit::Robot& robot, double since);

/// Away from a ball that the hull pushes along, the shortest way, looking at it.
Order let_go(const kit::View& view, const kit::Robot& robot);

/// A ball at the dribbler is kicked straight ahead: over a robot that stands in the way, or under it away.
///
/// @param speed  [m/s] of the flat kick
Order kick_ahead(const kit::View& view, const kit::Robot& robot, double speed);

/// With the ball at the dribbler: drives along `heading` [rad] with it, `speed` [m/s] at most.
Order carry(const kit::Robot& robot, double heading, double speed);

/// The ball lies at a wall or in a corner, where no robot gets behind it.
bool is_at_wall(const kit::View& view);

/// Gets such a ball back into the field: takes it square to the wall with the dribbler and backs off with it.
Order free_from_wall(const kit::View& view, const kit::Robot& robot);

}  // namespace skills
