#pragma once

#include "teams/reference/parameters.h"
#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// The ball is dead or belongs to them: slower than the limit, away from the ball and from where it will be
/// placed, no kicker, no dribbler.
///
/// @param slow  STOP: hold the speed limit too
void keep_away(const kit::View& view, const kit::Robot& robot, const Parameters& parameters, bool slow,
               skills::Order& order);

/// A kickoff is being prepared or taken: the robot stays in our half.
void stay_in_own_half(const kit::Robot& robot, skills::Order& order);

/// A penalty: everyone but kicker and goalie behind the line 0.4 m behind the mark (laws of 2015, Law 14).
void stay_behind_penalty_line(const kit::View& view, const kit::Robot& robot, skills::Order& order);

/// The robot nearest to the ball while it is dead or theirs: between ball and our goal, at the legal
/// distance.
skills::Order block_the_ball(const kit::View& view, const kit::Robot& robot, const Parameters& parameters);

/// Our kicker while the kickoff or penalty is prepared: behind the ball, not touching it.
skills::Order wait_behind_ball(const kit::View& view, const kit::Robot& robot);

/// Our penalty: beside the post the goalie is farther from.
skills::Order take_penalty(const kit::View& view, const kit::Robot& robot, const Parameters& parameters);

/// Our goalie against their penalty: on the line, opposite the ball.
skills::Order face_penalty(const kit::View& view, const kit::Robot& robot);

/// The robot that took the kick: out of everybody's way, far enough not to touch the ball again.
skills::Order leave_ball(const kit::View& view, const kit::Robot& robot);

}  // namespace reference
