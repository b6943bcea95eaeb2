#pragma once

#include "teams/kit/team.h"
#include "teams/skills/steer.h"

namespace chaser {

/// The smallest team that plays: the robot nearest to the ball goes behind it and kicks it at the goal, the
/// others spread over their own half. No goalie, no passes. Copy it and make it better.
class Chaser final : public kit::Team {
 public:
  /// Called once a tick. Everything is seen as if our goal were the one at -x.
  void play(const kit::View& view, world::TeamCommands& out) override;

 private:
  skills::Steering steering_;  // turns "be there, look there" into wheel commands, round the other robots
  int chaser_ = -1;            // who chased in the tick before
};

}  // namespace chaser
