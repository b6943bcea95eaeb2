#pragma once

#include <optional>
#include <string>
#include <variant>

#include "sim/world/geometry.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"
#include "sim/world/tracked_frame.h"

namespace world {

// Events that the league's protocol knows carry its names; the others are the paper's (6.4).

struct BallLeftFieldTouchLine {
  std::optional<Touch> last_touch;
  Vector2d location = Vector2d::Zero();  ///< [m] where it crossed the line
};

struct BallLeftFieldGoalLine {
  std::optional<Touch> last_touch;
  Vector2d location = Vector2d::Zero();  ///< [m] where it crossed the line
};

/// The ball entered a goal; whether it counts is the automaton's business.
struct PossibleGoal {
  Team defending{};  ///< whose goal
  std::optional<Touch> last_touch;
  Vector2d location = Vector2d::Zero();  ///< [m] where it crossed the goal line
};

struct BotKickedBallTooFast {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] where the kick was taken
  double speed = 0;                      ///< [m/s] highest consistent speed
};

struct BotDribbledBallTooFar {
  RobotId by;
  Vector2d start = Vector2d::Zero();  ///< [m] ball when the dribble began
  Vector2d end = Vector2d::Zero();    ///< [m] ball when the limit was passed
};

struct AttackerDoubleTouchedBall {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] ball at the second touch
};

struct NoProgressInGame {
  Vector2d location = Vector2d::Zero();  ///< [m] ball
  Duration waited{};
};

/// A robot touched the ball in play.
struct BallTouched {
  Touch touch;
};

/// The restart's kick was taken; the offences of that moment, if any (laws of 2015, Laws 8, 9 and 13).
struct KickTaken {
  RobotId by;
  Vector2d location = Vector2d::Zero();       ///< [m] where it was taken
  std::optional<RobotId> attacker_near_area;  ///< team-mate closer than 0.2 m to the opponents' defense area
  std::optional<RobotId> opponent_near_ball;  ///< opponent closer than 0.5 m to the ball
  std::optional<RobotId> wrong_half;          ///< at a kickoff: robot not in its own half
};

/// Ball in place, robots slow for long enough (paper, Algorithm 3) or the wait was too long.
struct RobotsSettled {
  bool waited_too_long = false;
};

struct GameEvent {
  Time time;
  std::variant<BallLeftFieldTouchLine, BallLeftFieldGoalLine, PossibleGoal, BotKickedBallTooFast,
               BotDribbledBallTooFar, AttackerDoubleTouchedBall, NoProgressInGame, BallTouched, KickTaken,
               RobotsSettled>
      what;
};

}  // namespace world
