#pragma once

#include <optional>
#include <span>

#include "teams/kit/view.h"

namespace skills {

using world::Vector2d;

/// A disc that stands in the way of a ball.
struct Blocker {
  Vector2d position = Vector2d::Zero();  ///< [m]
  double radius = 0;                     ///< [m] hull and ball and what it can still cover
};

/// The widest free angle between the ball and a segment.
struct Opening {
  Vector2d target = Vector2d::Zero();  ///< [m] where its middle meets the segment
  double direction = 0;                ///< [rad] of the middle
  double width = 0;                    ///< [rad]; 0: all blocked
};

/// Sweeps the angles from `from` to the segment and returns the widest free interval.
///
/// @param preferred  a direction aimed at before [rad]: its interval gets `bonus` [rad] in the comparison
/// Source  reference "football", 2.5
Opening widest_opening(const Vector2d& from, const world::Segment& segment, std::span<const Blocker> blockers,
                       std::optional<double> preferred = {}, double bonus = 0.02);

/// The opening to the opponents' goal, posts inset by the ball's radius.
///
/// Opponents are widened by what they can cover while the ball flies, min(a t^2 / 2, 0.25 m) after a reaction
/// time of 0.12 s. Our own robots count with their hull, but for `shooter`.
///
/// @param later  [s] until the shot: their goalkeeper has gone into its way as far as it gets by then
Opening opening_to_goal(const kit::View& view, const Vector2d& from, double kick_speed, int shooter,
                        std::optional<double> preferred = {}, double later = 0);

/// Only its width [rad], without the trigonometry of the rest.
double width_to_goal(const kit::View& view, const Vector2d& from, double kick_speed, int shooter,
                     double later = 0);

/// The angle at which their goal is seen from there [rad]: no opening is wider, not by the last bit either.
double width_of_goal(const kit::View& view, const Vector2d& from);

/// Where their goalkeeper will be after `later` seconds when the ball goes to `ball`: on the way from there
/// to the middle of the goal, as far from the goal as now.
///
/// It sees the ball go after 0.12 s and drives from rest to rest.
Vector2d goalie_later(const kit::View& view, const kit::Robot& goalie, const Vector2d& ball, double later);

/// The angle a kick in the heading `direction` may be wrong and still hit:
/// half of the width, at most 0.1 rad.
double kick_tolerance(double width);

/// Chance that a shot through an opening of that width passes, for a Gaussian kick error [0..1].
///
/// Source  reference "football", 2.5 (RoboJackets' form); the error of 0.04 rad covers aim and noise.
double chance_to_pass(double width, double sigma = 0.04);

}  // namespace skills
