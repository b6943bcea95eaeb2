#pragma once

#include <optional>

#include "teams/kit/view.h"
#include "teams/reference/choose_kick.h"

namespace reference {

/// Our restarts that have places of their own; every other free kick is played from the
/// supporters' usual places.
enum class SetPlay : std::uint8_t { None, Kickoff, Corner, GoalKick, NeutralStart, Penalty };
const char* name(SetPlay play);

/// Which of them this is.
///
/// Corner         the ball lies within 0.6 m of their goal line and 1 m of a touch line
/// Goal kick      our free kick from within a metre of our goal line
/// Neutral start  (anybody's) the ball still lies where it lay when the referee let both teams play it
SetPlay set_play(const kit::View& view);

/// Where supporter `index` waits in this set play [m]; nothing when it has no place of its own.
///
/// Corner         1.5 m out from the far post, the 45 degree edge of the area, a decoy beside the kicker
/// Kickoff        one beside the ball, to whom it is tapped, the others on both wings
/// Goal kick      up the ball's own flank, and across in midfield; nobody in front of our goal
/// Neutral start  one covers the robot that runs in
/// Penalty        behind the line, for the rebound
///
/// Source  reference "football", 2.9
std::optional<Vector2d> set_play_place(const kit::View& view, int index);

/// Where the pass to a supporter that waits there goes: the place itself, or what it runs to.
Vector2d set_play_target(const kit::View& view, const Vector2d& place);

/// The kick of those set plays that leave no choice: the kickoff is tapped to the robot beside the ball.
///
/// @param targets  of the supporters
std::optional<Kick> set_kick(const kit::View& view, std::span<const PassTarget> targets);

/// A goal kick when no pass is safe: a chip up the flank, away from our goal.
Kick long_goal_kick(const kit::View& view);

/// Our penalty: the direction beside the post that is farther from their goalie [rad].
double penalty_direction(const kit::View& view);

}  // namespace reference
