#pragma once

namespace vision {

/// How well the cameras see. The named presets are in sim/engine/realism.cpp.
struct Params {
  double ball_sigma = 0;         ///< [m] standard deviation of a ball position, per axis
  double robot_sigma = 0;        ///< [m] standard deviation of a robot position, per axis
  double orientation_sigma = 0;  ///< [rad]
  double ball_missing = 0;       ///< probability that the ball is missing in one image
  double robot_missing = 0;      ///< probability that one robot is missing in one image
  double overlap = 0.25;         ///< [m] how far a camera sees beyond the middle line to its neighbour
  int delay = 0;                 ///< [ticks] from the tick of capture to the tick of delivery
};

}  // namespace vision
