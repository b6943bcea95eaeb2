#pragma once

#include <optional>

#include "teams/kit/ball_model.h"
#include "teams/kit/view.h"

namespace reference {

using world::Vector2d;

/// What it is worth to receive a flat pass at a point: V(q) without the receiver.
///
///   V(q) = P_reach P_safe [w_s P_goal + w_a A]
///
/// Source  reference "football", 2.6
struct Reception {
  double speed = 0;      ///< [m/s] of the kick
  double ball_time = 0;  ///< [s] the ball needs
  double safety = 0;     ///< P_safe
  double goal = 0;       ///< P_goal of the shot that follows, less for one that first has to turn
  double advance = 0;    ///< A
  double share = 0;      ///< of P_goal, by the angle of the redirect
  double later = 0;      ///< [s] from the kick to the shot

  /// P_safe [w_s P_goal + w_a A]
  double value() const;
};

/// @param receiver  its own hull does not stand in the way of its shot; -1: nobody's
/// @param arrival   [m/s] of the ball; nothing: 3.5 where it may be shot on at once, else 2.2
Reception reception_at(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                       const Vector2d& point, int receiver = -1, std::optional<double> arrival = {});

/// Its two parts: the pass, with P_goal 0, and then P_goal.
Reception pass_at(const kit::View& view, const kit::BallModel& model, const Vector2d& from,
                  const Vector2d& point, std::optional<double> arrival = {});
double goal_after(const kit::View& view, const Vector2d& point, const Reception& pass, int receiver = -1);

/// P_safe 1 and nobody before the goal: worth at least as much as the reception itself, and cheap.
Reception best_case_at(const kit::View& view, const Vector2d& from, const Vector2d& point);

/// P_reach: chance that the receiver is there with the ball.
///
/// @param own_time   [s] until it can be there
/// @param ball_time  [s] until the ball is: of the kicker to the ball and of the pass
double reach_chance(double own_time, double ball_time);

/// Chance of a goal by a shot from that point: the widest opening against 0.3 rad, nothing from afar.
///
/// @param later  [s] until the shot, for their goalkeeper
/// Source        reference "football", 2.5
double goal_chance(const kit::View& view, const Vector2d& point, double shot_speed, int shooter,
                   double later = 0);
/// @param guarded  false: nobody there to use the time of a long shot
double goal_chance(double opening_width, double distance, bool guarded = true);
bool is_guarded(const kit::View& view);  ///< their goalkeeper is on the field

/// How good the angle at `point` between the ball's way in and the way to their goal is for a shot at the
/// first touch: 1 up to 60 degrees, falling to 0.4 at 120, where it must be stopped and turned.
double redirect_share(const kit::View& view, const Vector2d& from, const Vector2d& point);

}  // namespace reference
