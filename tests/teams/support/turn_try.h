#pragma once

#include <cstdint>

#include "teams/skills/turn_dribble.h"

namespace support {

/// How one turn with the ball went.
struct TurnTry {
  bool kept = false;      ///< the ball was at the dribbler all the time, and 0.1 s after the end
  double time = 0;        ///< [s] until the heading was right within 0.1 rad
  double ball_moved = 0;  ///< [m] farthest from where it began
};

/// A robot alone with the ball at its dribbler turns by `angle` [rad] on that circle.
TurnTry try_turn(const skills::TurnCircle& circle, double angle, std::uint64_t seed, const char* realism);

}  // namespace support
