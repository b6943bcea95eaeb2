#pragma once

#include "teams/kit/view.h"

namespace reference {

enum class Possession : std::uint8_t { None, Ours, Theirs, Contested };
const char* name(Possession possession);

/// Who has the ball by being at it: a team has it when one of its robots was within 40 mm for 0.1 s, and
/// keeps it (a pass is on its way) until 1.5 s after the last of its robots was within 80 mm, or until the
/// other team has it. A ball higher than 0.12 m is nobody's.
///
/// Source  reference "football", 2.8 (possession tracker)
class PossessionTracker {
 public:
  Possession update(const kit::View& view);

  /// Both, one or none of the teams has a robot at the ball right now.
  Possession at_ball() const { return at_ball_; }

 private:
  struct Side {
    double near_since = -1;  // [s] -1: nobody is near
    double last_near = -9;   // [s] somebody within the wide gap
    bool has = false;
  };
  void watch(const kit::View& view, const std::vector<kit::Robot>& robots, Side& side) const;

  Side ours_, theirs_;
  Possession at_ball_ = Possession::None;
};

}  // namespace reference
