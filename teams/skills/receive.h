#pragma once

#include <optional>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/skills/intercept.h"
#include "teams/skills/order.h"

namespace skills {

/// Where the ball will come to a robot that receives it: where it stands when it is on the ball's line, else
/// where it meets the ball.
///
/// @param facing  where it looks then [rad]; nothing: at the ball
/// @return  nothing when the ball is slow, or at rest before it could be met: it is to be fetched
std::optional<Meeting> arrival(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model,
                               std::optional<double> facing = {});

/// Stands in the way of a moving ball, looking at it, dribbler on. Fetches a ball that does not come.
Order receive(const kit::View& view, const kit::Robot& robot, const kit::BallModel& model);

/// The angle by which a one-touch kick along `direction` [rad] turns the ball back from where it came [rad]:
/// 0 straight back, pi straight on.
double redirect_angle(const Vector2d& ball_velocity, double direction);

/// Beyond this angle [rad] the ball meets the edge of the front instead of the kicker (reference "football",
/// 2.4: 45 to 60 degrees; one_touch in tests/teams).
inline constexpr double steepest_redirect = 1.0;

/// One touch: stands so that the ball at `where` meets the middle of the front while the robot looks along
/// `direction`, and kicks as soon as it is there.
///
/// The kicker gives the ball its speed along the heading whatever it had before; so the heading is the
/// direction wanted, less what the robot's own sideways motion adds.
///
/// @param direction  of the ball afterwards [rad]
/// Source  reference "football", 2.4; there the ball keeps a tenth of its speed across the front, in our
///         simulator nothing
Order redirect(const kit::View& view, const kit::Robot& robot, const Meeting& where, double direction,
               double kick_speed, double tolerance);

}  // namespace skills
