#pragma once

namespace vision {

/// How many cameras there are and how well they see. All zero: perfect eyes. The named presets are in
/// sim/engine/realism.cpp, every key with its range and meaning in sim/engine/realism_keys.cpp.
struct Params {
  // The set-up.
  int cameras = 4;             ///< 1, 2, 4, 6 or 8, over equal parts of the field
  double camera_height = 4.0;  ///< [m]
  double overlap = 0.25;       ///< [m] how far a camera sees beyond the middle line to its neighbour
  int delay = 0;               ///< [ticks] from the tick of capture to the tick of delivery

  // Errors of what is seen.
  double ball_sigma = 0;         ///< [m] standard deviation of a ball position, per axis
  double robot_sigma = 0;        ///< [m] standard deviation of a robot position, per axis
  double orientation_sigma = 0;  ///< [rad]
  double bias_sigma = 0;  ///< [m] standard deviation, per axis, of a camera's constant offset in one game
  double area_sigma = 0;  ///< [px] standard deviation of a ball's pixel area

  // What is not seen.
  double ball_missing = 0;   ///< probability that the ball is missing in one image
  double robot_missing = 0;  ///< probability that one robot is missing in one image
  double visible_share = 0;  ///< a ball of which less than this share is visible is not seen; 0: no occlusion
  double ball_burst_start = 0;    ///< probability in one image that a burst of ball losses begins
  double ball_burst_length = 5;   ///< [images] mean length of such a burst
  double robot_burst_start = 0;   ///< the same for each robot
  double robot_burst_length = 5;  ///< [images]

  // Poorly calibrated regions: discs at random places of each camera's area, the same for a whole game.
  int regions = 0;             ///< per camera
  double region_radius = 0.5;  ///< [m]
  double region_missing = 0;   ///< probability that a ball inside is missing in one image: flicker
  double region_offset = 0;    ///< [m] error of all positions at the centre, falling to 0 at the rim

  // What is seen and is not there.
  double false_ball_rate = 0;   ///< [1/s] per camera; half of them lie on a robot and move with it
  int false_ball_shortest = 3;  ///< [images] a false ball lasts
  int false_ball_longest = 30;  ///< [images]
  double misread_id = 0;        ///< probability in one image that a robot is given another number
  double unread_id = 0;         ///< probability in one image that a robot is given no number
};

}  // namespace vision
