#pragma once

#include <optional>
#include <span>

#include "teams/reference/parameters.h"
#include "teams/reference/situation.h"

namespace reference {

using world::Vector2d;

/// Where a pass to a team-mate may go.
struct PassTarget {
  int receiver = -1;
  Vector2d point = Vector2d::Zero();  ///< [m]
};

/// What to do with the ball.
struct Kick {
  enum class Kind : std::uint8_t { Shot, Pass, Clear, Dribble };
  Kind kind = Kind::Dribble;
  Vector2d target = Vector2d::Zero();  ///< [m]
  double direction = 0;                ///< [rad] of the kick
  double speed = 0;                    ///< [m/s]
  double angle = 0;                    ///< [rad] elevation
  double tolerance = 0.05;             ///< [rad] the heading may be wrong by this
  int receiver = -1;
  double value = 0;  ///< chance of a goal from it, roughly
};
const char* name(Kick::Kind kind);

/// What a kick may be now: rules of the restart, and where passes may go.
struct KickRules {
  bool shot_allowed = true;      ///< false: an indirect kick
  bool must_go_forward = false;  ///< a kickoff
  bool must_kick = false;        ///< a restart: no dribbling
  bool only_targets = false;     ///< passes go to `targets` and to nobody else
  /// A set play that says the kick itself: nothing is left to choose.
  std::optional<Kick> given{};
  /// What to do in place of a pass of less value than usual, or of a clearance.
  std::optional<Kick> otherwise{};
  /// Points for the receivers; a team-mate without one may get the ball where it is.
  std::span<const PassTarget> targets{};
};

/// Until the robot has the ball [s]; 0 when it holds it.
double time_to_ball(const kit::View& view, const Situation& situation, const kit::Robot& robot);

/// The best use of the ball where it lies: a shot when the opening promises a goal, else the best pass, else
/// forward with the ball; from near the own goal away with it.
///
/// @param before  the choice of the tick before: kept unless another is better by 0.05
Kick choose_kick(const kit::View& view, const Situation& situation, int kicker, const KickRules& rules,
                 const Parameters& parameters, const std::optional<Kick>& before);

}  // namespace reference
