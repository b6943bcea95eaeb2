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

/// Icing: a kick from its own half went over the opponents' goal line, beside the goal, untouched.
struct AimlessKick {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] where it crossed the goal line
  Vector2d kick = Vector2d::Zero();      ///< [m] ball at the kick
};

/// The ball went into the opponents' goal after it had been higher than a chip may be.
struct ChippedGoal {
  RobotId by;                            ///< who made it fly
  Vector2d location = Vector2d::Zero();  ///< [m] where it crossed the goal line
  Vector2d kick = Vector2d::Zero();      ///< [m] ball when it was chipped
  double highest = 0;                    ///< [m] top of the ball
};

/// One robot ran into an opponent.
struct BotCrashUnique {
  RobotId by;  ///< the faster one
  RobotId victim;
  Vector2d location = Vector2d::Zero();  ///< [m] midpoint
  double speed = 0;                      ///< [m/s] at which they closed in, along the line between them
  double speed_difference = 0;           ///< [m/s] of their parts in it
  double angle = 0;                      ///< [rad] between their velocities, 0 to pi
  bool advantage = false;                ///< the victim's team-mate has the ball: play on
};

/// Two robots ran into each other, both about equally fast.
struct BotCrashDrawn {
  PerTeam<RobotId> robots;
  Vector2d location = Vector2d::Zero();  ///< [m] midpoint
  double speed = 0;                      ///< [m/s] at which they closed in, along the line between them
  double speed_difference = 0;           ///< [m/s] of their parts in it
  double angle = 0;                      ///< [rad] between their velocities, 0 to pi
};

/// A robot touched the opponents' goalie, the point of contact in the goalie's defense area.
struct AttackerTouchedKeeper {
  RobotId by;
  RobotId keeper;
  Vector2d location = Vector2d::Zero();  ///< [m] the point of contact
};

/// A robot other than the goalie touched the ball in its own defense area.
struct DefenderInDefenseArea {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] the robot at that time
  double depth = 0;                      ///< [m] how far its hull was inside
  bool wholly = false;                   ///< or partly
};

/// A robot touched the ball while partly or wholly in the opponents' defense area.
struct AttackerTouchedBallInDefenseArea {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] the robot at that time
  Vector2d ball = Vector2d::Zero();      ///< [m]
  double depth = 0;                      ///< [m] how far its hull was inside
};

/// A goalie held the ball in its area too long.
struct KeeperHeldBall {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] ball
  Duration held{};
};

/// A robot drove too fast under STOP.
struct BotTooFastInStop {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] the robot
  double speed = 0;                      ///< [m/s]
};

/// A robot stayed too near the ball under STOP.
struct BotTooNearInStop {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] the robot
  double distance = 0;                   ///< [m] hull to ball
};

/// A robot stood in the way of the ball that was to be put in its place.
struct BotInterferedPlacement {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] the robot
};

/// A robot stayed beyond the free run-off around the field.
struct BotLeftField {
  RobotId by;
  Vector2d location = Vector2d::Zero();  ///< [m] the robot
  double distance = 0;                   ///< [m] its centre from the lines
};

/// A team plays with more robots than it may.
struct TooManyRobots {
  Team team{};
  int robots = 0;
  int allowed = 0;
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
  bool again = false;  ///< an opponent was near the ball at the last attempt at this free kick too
};

/// Ball in place, robots slow for long enough (paper, Algorithm 3) or the wait was too long.
struct RobotsSettled {
  bool waited_too_long = false;
};

struct GameEvent {
  Time time;
  std::variant<BallLeftFieldTouchLine, BallLeftFieldGoalLine, PossibleGoal, BotKickedBallTooFast,
               BotDribbledBallTooFar, AttackerDoubleTouchedBall, AimlessKick, ChippedGoal, BotCrashUnique,
               BotCrashDrawn, AttackerTouchedKeeper, DefenderInDefenseArea, AttackerTouchedBallInDefenseArea,
               KeeperHeldBall, BotTooFastInStop, BotTooNearInStop, BotInterferedPlacement, BotLeftField,
               TooManyRobots, NoProgressInGame, BallTouched, KickTaken, RobotsSettled>
      what;
};

}  // namespace world
