#pragma once

#include <array>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"
#include "teams/reference/possession.h"
#include "teams/skills/intercept.h"

namespace reference {

/// Facts about this tick that several tactics share.
struct Situation {
  kit::BallModel model;
  /// When and where each of our robots can have the ball, by number.
  std::array<skills::Meeting, world::max_robot_number + 1> meetings{};
  double our_time = 9;    ///< [s] until the first of us who may touch it is at the ball
  double their_time = 9;  ///< [s] until the first opponent is at the ball
  int their_first = -1;   ///< that opponent's number
  Possession possession = Possession::None;
};

/// Computes them; keeps between ticks what need not be new every time.
class Observer {
 public:
  const Situation& observe(const kit::View& view);

 private:
  void meet_the_ball(const kit::View& view);
  Possession judge(const kit::View& view);

  Situation situation_;
  std::array<skills::Meeting, world::max_robot_number + 1> their_meetings_{};
  PossessionTracker tracker_;
  double candidate_since_ = 0;  // [s]
  Possession candidate_ = Possession::None;
};

}  // namespace reference
