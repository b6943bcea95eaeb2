#pragma once

#include <string>

#include "teams/kit/flags.h"

namespace reference {

/// Everything about the team's style that can be set from outside. Values without another source are ours,
/// chosen by watching games.
struct Parameters {
  /// [m/s] the laws allow 8; the robot's own speed and the filter's noise come on top
  double shot_speed = 6.5;
  double shot_threshold = 0.14;    ///< chance of a goal from which a shot is taken at once
  double shot_bonus = 0.2;         ///< value of a shot beyond its chance, against passes
  double pass_threshold = 0.2;     ///< value from which a pass is played
  std::string attack = "zones";    ///< feature Z, zones or greedy: how supporters choose their places
  double stop_speed = 1.4;         ///< [m/s] during STOP; the laws allow 1.5
  double stop_distance = 0.6;      ///< [m] hull to ball during STOP and their kicks; the laws ask 0.5
  double dribble_distance = 0.85;  ///< [m] then the ball is let go; the laws allow 1.0 ("football", 2.10)
  double kick_delay = 0.5;         ///< [s] after the referee's signal before a free kick is taken
  bool turn_dribble = true;  ///< feature D: turn with the ball at the dribbler; else let go and go round it
  double turn_rate = 8;      ///< [rad/s] of such turns; 9 is the last row of the measured table
  int defenders = 2;         ///< besides the goalkeeper, while nobody has the ball
};

/// Makes each of them a flag with its range.
void declare(kit::Flags& flags, Parameters& parameters);

}  // namespace reference
