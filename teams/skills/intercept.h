#pragma once

#include <optional>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/skills/motion.h"

namespace skills {

/// A flying ball higher than this [m] is not stopped by a robot's front: robots are 0.15 m high, the ball's
/// radius and the filter's error of height go off (reference "football", 2.4: 0.12 to 0.15 m).
inline constexpr double highest_capture = 0.1;

/// Where and when a robot can meet the ball.
struct Meeting {
  Vector2d position = Vector2d::Zero();  ///< [m] of the ball
  double time = 0;                       ///< [s] from now
  bool before_it_stops = false;          ///< false: the ball will lie there already
};

/// The earliest place on the ball's way that the robot reaches `reserve` seconds before the ball; where the
/// ball comes to rest (or leaves the field) when there is none.
///
/// 8 samples over at most 2.5 s and the moment when the ball passes the robot; then the sign change is
/// refined by regula falsi. A ball in the air is met where it is low enough: seldom before its first landing,
/// else between low hops or rolling.
///
/// @param reach  distance from the robot's centre to the ball when it has it [m]
/// Source  reference "football", 2.4
Meeting meet(const kit::View& view, const kit::Robot& robot, const Limits& limits,
             const kit::BallModel& model, double reach, double reserve = 0.1);

}  // namespace skills
