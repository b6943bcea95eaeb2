#pragma once

#include "teams/reference/parameters.h"
#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// The robot nearest to the ball while it is dead or theirs: between ball and our goal,
/// at the legal distance.
skills::Order block_the_ball(const kit::View& view, const kit::Robot& robot, const Parameters& parameters);

/// Our kicker while the kickoff or penalty is prepared: behind the ball, not touching it.
skills::Order wait_behind_ball(const kit::View& view, const kit::Robot& robot);

/// Our penalty: beside the post the goalie is farther from.
skills::Order take_penalty(const kit::View& view, const kit::Robot& robot, const Parameters& parameters);

/// Our goalie against their penalty: on the line until the ball moves, a little towards
/// where the kicker looks.
skills::Order face_penalty(const kit::View& view, const kit::Robot& robot);

/// The robot that took the kick: out of everybody's way, far enough not to touch the ball again.
skills::Order leave_ball(const kit::View& view, const kit::Robot& robot);

}  // namespace reference
