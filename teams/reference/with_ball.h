#pragma once

#include "teams/reference/choose_kick.h"
#include "teams/skills/order.h"

namespace reference {

/// A robot's time with the ball at its dribbler.
struct Hold {
  Vector2d start = Vector2d::Zero();  ///< [m] the ball's place farthest from here since contact began
  double time = 0;                    ///< [s] since then
};

/// What the robot does with the ball at its dribbler.
enum class WithBall : std::uint8_t {
  Settle,     ///< the first three frames: let the bar take hold; kick when aligned already
  Align,      ///< less than 12 degrees to go: turn the rest with the ball, kick
  Turn,       ///< feature D on: carry it round on a circle, sheltering it, and kick
  Release,    ///< feature D off: let go of it, to go round it
  Carry,      ///< along the heading with it
  KickAhead,  ///< too far, too long or too hard pressed: forward with it
};
const char* name(WithBall what);

/// Feature D, `--turn-dribble`: on turns with the ball, off releases it and goes round. Nothing else differs.
///
/// Source  reference "football", 2.10: from 12 degrees on; a dribble ends after `dribble_distance`
/// @param their_time  [s] until the first opponent is at the ball
WithBall choose_with_ball(const kit::View& view, const kit::Robot& robot, const Kick& kick, const Hold& hold,
                          double their_time, const Parameters& parameters);

/// How long until a kick by `angle` [rad] from the heading, the ball being at the dribbler [s]:
/// turning or going round.
double time_to_align(const kit::View& view, const kit::Robot& robot, double angle,
                     const Parameters& parameters);

/// How to get a ball that rests: round it, so as to be aligned when it is reached, or the shortest way and
/// align with it afterwards. Whichever is aligned first; round it only when nobody else gets there before.
///
/// @param ahead_of_them  [s] their time to the ball less ours
bool goes_round(const kit::View& view, const kit::Robot& robot, double direction, double ahead_of_them,
                const Parameters& parameters);

/// The order for that.
///
/// @param released  [s] since the release began; 0 otherwise
skills::Order order_with_ball(const kit::View& view, const kit::Robot& robot, WithBall what, const Kick& kick,
                              const Hold& hold, double released, const Parameters& parameters);

}  // namespace reference
