#pragma once

#include "sim/world/time.h"

namespace tracker {

/// What the filter assumes of cameras, ball and robots. The defaults suit the preset `measured` and stay
/// usable with several times its noise.
struct Params {
  // Cameras: the standard deviations of the preset `measured`.
  double ball_sigma = 0.0005;     ///< [m]
  double robot_sigma = 0.00055;   ///< [m]
  double heading_sigma = 0.0035;  ///< [rad]

  // Offsets of the cameras against each other (camera_bias.h).
  double bias_sigma = 0.010;    ///< [m] prior per axis (football.md 3.2); 0: none is estimated
  double bias_drift = 0.00013;  ///< [m/s^0.5] 1 mm in a minute; ours
  double local_sigma = 0.003;   ///< [m] what calibration errs differently from place to place; ours
  double largest_bias = 0.05;   ///< [m] half of the worst that football.md 5 knows of two cameras

  // Ball. Process noise is white acceleration: a value a makes the velocity wander by a/60 m/s in a frame.
  double rolling_noise = 0.15;   ///< [m/s^2] ours, from NIS; football.md 3.2 proposes 0.3
  double sliding_noise = 0.5;    ///< [m/s^2] ours, from NIS
  double erratic_noise = 12.0;   ///< [m/s^2] 0.2 m/s per frame, CMDragons' near a robot (football.md 3.1)
  double near_gap = 0.05;        ///< [m] hull to ball; a robot covers it in one frame at 3 m/s
  double kick_sigma = 5.0;       ///< [m/s] of the velocity after a collision: the next frame decides it
  double max_ball_speed = 12.0;  ///< [m/s] faster is another ball; cap of TIGERs' autoref (football.md 4.2)
  double ball_gate = 0.01;       ///< [m] nearer than this is the same ball whatever the statistics say
  world::Duration ball_memory = std::chrono::seconds{3};     ///< then an unseen ball is forgotten; ours
  world::Duration hidden_memory = std::chrono::seconds{10};  ///< the same of one that robots hide; ours

  bool ball_in_space = true;  ///< chips are found and followed; false: the ball is always on the ground

  // Robots: white acceleration as above, tuned for mean NIS 1 in game-like motion at 3 m/s^2 and 50 rad/s^2.
  double robot_noise = 3.0;  ///< [m/s^2]
  double turn_noise = 25.0;  ///< [rad/s^2]
  double robot_gate = 0.12;  ///< [m] two robots cannot be so near: the same id there is the same robot
  world::Duration robot_memory = std::chrono::milliseconds{500};  ///< ours: README, Decisions

  double nis_gate = 13.816;  ///< chi-square, 2 degrees of freedom, 99.9 %
  int confirmations = 3;     ///< consistent sightings that make a track (football.md 3.2)
};

}  // namespace tracker
