#pragma once

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/skills/order.h"

namespace skills {

/// Where the centre of a robot stands when the ball lies at its dribbler and it looks along `direction`.
Vector2d behind_ball(const Vector2d& ball, const Vector2d& direction, const kit::Robot& robot,
                     double ball_radius, double gap = 0);

/// Gets behind the ball and then drives through it, so that a kick goes along `direction` [rad].
///
/// Far or on the wrong side: go to a point behind the ball, round it. Behind it: drive straight on, the
/// kicker armed once the heading is within `tolerance` [rad].
///
/// @param kick_speed  [m/s]; 0: only take the ball
/// Source  reference "football", 2.8 (approach) and the kick gate there
Order approach_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                        double kick_angle, double tolerance);

/// Takes the ball with the dribbler the shortest way: straight at it, looking at it.
Order capture(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model);

/// With the ball at the dribbler: turn with it towards `direction`, slowly enough to keep it, and kick when
/// aligned.
Order turn_and_kick(const kit::View& view, const kit::Robot& robot, double direction, double kick_speed,
                    double kick_angle, double tolerance);

/// Stands in the way of a moving ball, looking at it, dribbler on.
Order receive(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model);

}  // namespace skills
