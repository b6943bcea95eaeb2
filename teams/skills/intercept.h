#pragma once

#include <optional>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/skills/motion.h"

namespace skills {

/// Where and when a robot can meet the ball.
struct Meeting {
  Vector2d position = Vector2d::Zero();  ///< [m] of the ball
  double time = 0;                       ///< [s] from now
  bool before_it_stops = false;          ///< false: the ball will lie there already
};

/// The earliest place on the ball's way that the robot reaches `reserve` seconds before the ball; where the
/// ball comes to rest (or leaves the field) when there is none.
///
/// 8 samples over at most 2.5 s, then the sign change is refined by regula falsi.
///
/// @param reach  distance from the robot's centre to the ball when it has it [m]
/// Source  reference "football", 2.4
Meeting meet(const kit::View& view, const kit::Robot& robot, const Limits& limits,
             const kit::BallModel& model, double reach, double reserve = 0.1);

}  // namespace skills
