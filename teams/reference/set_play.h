#pragma once

#include <optional>

#include "teams/kit/view.h"

namespace reference {

using world::Vector2d;

/// Our restarts that have places of their own; every other free kick is played from the supporters' usual
/// places.
enum class SetPlay : std::uint8_t { None, Kickoff, Corner, Penalty };
const char* name(SetPlay play);

/// Which of them this is: ours, and a corner when the ball lies within 0.6 m of their goal line and 1 m of a
/// touch line.
SetPlay set_play(const kit::View& view);

/// Where supporter `index` of `count` waits in this set play [m]; nothing when it has no place of its own.
///
/// Corner: the far post 1.5 m out, the 45 degree edge of the area, a decoy beside the kicker.
/// Kickoff: on both wings behind the halfway line. Penalty: behind the line, for the rebound.
/// Source  reference "football", 2.9
std::optional<Vector2d> set_play_place(const kit::View& view, int index, int count);

/// Where the pass to a supporter that waits there goes: the place itself, or what it runs to.
Vector2d set_play_target(const kit::View& view, const Vector2d& place);

/// Our penalty: the direction beside the post that is farther from their goalie [rad].
double penalty_direction(const kit::View& view);

}  // namespace reference
