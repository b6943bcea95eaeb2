#pragma once

#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// What the goalie does in this tick, given the world: intercept a shot, clear a ball that is slow in or near
/// the area, go out to a ball it reaches before a lone attacker, else guard.
skills::Order play_goalie(const kit::View& view, const Situation& situation, const kit::Robot& robot);

/// Away with the ball: a pass to a free mate when that is safe, else a chip to the open flank.
skills::Order clear_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot);

/// The goalie reaches the ball 0.1 s before any opponent and before all of its own, within 1.5 m of the area.
bool goes_out(const kit::View& view, const Situation& situation, const kit::Robot& robot);

/// The only robot of the team may play the ball: it is there first, by more the farther away from the goal.
bool may_leave_goal(const kit::View& view, const Situation& situation, const kit::Robot& robot);

/// The place where the goalie guards: on the line from the ball to the goal's middle, where it takes the same
/// time to either post.
Vector2d guard_position(const kit::View& view, const kit::Robot& robot);

}  // namespace reference
