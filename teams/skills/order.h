#pragma once

#include <limits>
#include <optional>

#include "sim/world/geometry.h"

namespace skills {

using world::Vector2d;

/// What one robot is to do in this tick: the language between tactics and steering. Own frame.
struct Order {
  const char* why = "";  ///< for notes and tests: the tactic in a word

  Vector2d target = Vector2d::Zero();                          ///< [m] where to come to rest
  double heading = 0;                                          ///< [rad] where to look
  double max_speed = std::numeric_limits<double>::infinity();  ///< [m/s]
  double max_turn = std::numeric_limits<double>::infinity();   ///< [rad/s]
  /// Drive with this velocity [m/s] instead of going to the target: the last steps at the ball.
  std::optional<Vector2d> velocity;

  double ball_distance = -1;  ///< [m] keep the hull this far from the ball; negative: the ball is no obstacle
  /// [m] air to other robots; negative: none are obstacles (pressing at the ball)
  double robot_margin = 0.03;
  bool enter_own_area = false;  ///< the goalkeeper
  double their_area = 0.02;     ///< [m] hull to the opponents' defense area

  double kick_speed = 0;  ///< [m/s]
  double kick_angle = 0;  ///< [rad]
  bool dribble = false;
  double dribble_share = 1;  ///< of the bar's full speed
};

}  // namespace skills
