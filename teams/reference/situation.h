#pragma once

#include <array>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/skills/intercept.h"

namespace reference {

enum class Possession : std::uint8_t { None, Ours, Theirs, Contested };
const char* name(Possession possession);

/// Facts about this tick that several tactics share.
struct Situation {
  kit::BallModel model;
  /// When and where each of our robots can have the ball, by number.
  std::array<skills::Meeting, world::max_robot_number + 1> meetings{};
  double their_time = 9;  ///< [s] until the first opponent is at the ball
  int their_first = -1;   ///< that opponent's number
  Possession possession = Possession::None;
};

/// Computes them; keeps between ticks what need not be new every time.
class Observer {
 public:
  const Situation& observe(const kit::View& view);

 private:
  Situation situation_;
  int possession_ticks_ = 0;
  Possession candidate_ = Possession::None;
};

}  // namespace reference
