#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/detection.h"
#include "sim/world/field.h"

namespace scene {

/// Losses of one object: single misses, and bursts as E. N. Gilbert's channel has them.
struct Losses {
  double missing = 0;
  double burst_start = 0;
  double burst_length = 5;
};

/// Errors that cameras make, known exactly; not the simulator's own code, so that one can tell of the other.
struct Errors {
  double ball_sigma = 0.0005;
  double robot_sigma = 0.0005;
  double orientation_sigma = 0.003;
  double area_sigma = 6;
  std::vector<world::Vector2d> offsets = {};  ///< of each camera; none: no bias
  Losses ball;
  Losses robot;
  double false_ball_rate = 0;  ///< [1/s] per camera; half of them ride on a robot
  int false_ball_shortest = 3;
  int false_ball_longest = 30;
  double misread = 0;
  double unread = 0;
  double delay = 0.02;  ///< [s]
};

/// `seconds` of images of 2 or 4 cameras at 60 Hz, each a quarter of an image after the other: a ball on a
/// slow curve over the whole field, and four robots of each team on circles.
std::vector<world::Detection> images(int cameras, double seconds, const Errors& errors, std::uint64_t seed);

/// The field and cameras of these images.
world::Geometry geometry(int cameras);

inline constexpr double overlap = 0.4;  ///< [m]

}  // namespace scene
