#pragma once

#include <optional>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"

namespace skills {

using world::Vector2d;

/// A pass, flat or chipped.
struct Pass {
  Vector2d target = Vector2d::Zero();  ///< [m] where the ball is to be received
  double speed = 0;                    ///< [m/s] of the kick
  double angle = 0;                    ///< [rad] elevation
  double time = 0;                     ///< [s] the ball needs
  double safety = 0;                   ///< [0..1] chance that no opponent gets it first
};

/// Chance that no opponent reaches a flat ball before it has covered the way to `to` [0..1].
///
/// Per opponent the least of (its time to a point of the line - the ball's) over three points of the line,
/// then a logistic with 0.1 s.
///
/// Source  reference "football", 2.6; three points instead of one each 0.3 m, to save time (ours)
double pass_safety(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                   const Vector2d& to, double speed);

/// A pass to that point which arrives at about `arrival` [m/s], its speed held in [2.0, 6.5] m/s (the laws
/// forbid 8, the filter's noise and the robot's own speed need the rest).
Pass plan_pass(const kit::View& view, const kit::BallModel& model, const Vector2d& from, const Vector2d& to,
               double arrival = 2.2);

/// A chip at 45 degrees over an opponent that blocks the ground near the ball, landing at least 0.3 m beyond
/// it and 0.2 m before the target.
///
/// Carry v^2 / g; after the first landing 5/7 of the horizontal speed are left (a ball that starts to roll).
/// @return  nothing when the ground is free or no such chip exists
/// Source  reference "football", 2.6
std::optional<Pass> plan_chip(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                              const Vector2d& to);

}  // namespace skills
