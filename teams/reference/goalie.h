#pragma once

#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// What the goalie does in this tick, given the world: intercept a shot, clear a ball at rest in the area,
/// guard.
skills::Order play_goalie(const kit::View& view, const Situation& situation, const kit::Robot& robot);

/// The place where the goalie guards: on the line from the ball to the goal's middle, where it takes the same
/// time to either post.
Vector2d guard_position(const kit::View& view, const kit::Robot& robot);

}  // namespace reference
