#pragma once

#include <optional>

#include "teams/kit/view.h"
#include "teams/skills/order.h"

namespace rough {

/// A kick planned.
struct Kick {
  double direction = 0;  ///< [rad]
  double speed = 0;      ///< [m/s]
  double angle = 0;      ///< [rad] above the ground
};

/// Over the opponents' goal line beside the goal where there is most room;
/// through the air where the way is not free.
Kick plan_clearance(const kit::View& view, const kit::Robot& robot);

/// To the nearer goalie, to arrive at a walk; nothing where there is none.
std::optional<Kick> plan_feeding(const kit::View& view);

/// Where the ball is to be when it is kicked, along x [m].
struct Stretch {
  double from, to;
};

/// Clears a ball that lies.
skills::Order clear_from_rest(const kit::View& view, const kit::Robot& robot);

/// With the ball at the dribbler: turns, takes it to the stretch, forwards or backwards, and kicks.
skills::Order clear_from_dribbler(const kit::View& view, const kit::Robot& robot, const Stretch& stretch);

}  // namespace rough
