#pragma once

#include "teams/reference/parameters.h"
#include "teams/reference/roles.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// What the laws leave of an order in the present phase of the game: distances, speed, halves, areas, no kick
/// of a ball that is not ours. The last word before steering; does nothing while the ball is in play.
void make_legal(const kit::View& view, const kit::Robot& robot, const Roles& roles,
                const Parameters& parameters, skills::Order& order);

/// The nearest place to `point` whose hull keeps `distance` from the ball (measured as the laws do, hull to
/// ball) and stays outside both defense areas, or outside theirs alone for the goalie [m].
///
/// Out along the ray from the ball; where that ends in an area or at the wall, round the ball to the nearest
/// free direction.
Vector2d clear_of_ball(const kit::View& view, const kit::Robot& robot, const Vector2d& point,
                       const Vector2d& ball, double distance, bool goalie);

/// The ball is dead: nobody plays it, everybody is slow and out of its way.
bool is_dead(kit::Phase phase);
bool is_kickoff(kit::Phase phase);
bool is_penalty(kit::Phase phase);

}  // namespace reference
