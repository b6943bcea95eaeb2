#pragma once

#include "teams/reference/situation.h"
#include "teams/skills/order.h"

namespace reference {

using world::Vector2d;

/// A place in the wall: on the line from the ball to our goal just outside the defense area, `index` of
/// `count` robots side by side.
Vector2d wall_position(const kit::View& view, int index, int count);

/// How dangerous an opponent without the ball is [s]: the time a pass to it and a shot from it would take;
/// less is worse.
///
/// Source  reference "football", 2.7 (threat score)
double threat_time(const kit::View& view, const kit::Robot& opponent);

/// Between the opponent and our goal, near enough to cut the pass.
Vector2d mark_position(const kit::View& view, const kit::Robot& opponent);

/// Defenders: the first ones form the wall while the ball is dangerous, the others mark the worst threats.
///
/// @param index, count  of the defenders, from the right (-y) to the left
skills::Order play_defender(const kit::View& view, const Situation& situation, const kit::Robot& robot,
                            int index, int count);

}  // namespace reference
