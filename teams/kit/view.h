#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/world/field.h"
#include "sim/world/robot_specs.h"
#include "sim/world/time.h"

namespace kit {

using world::Vector2d;

/// The ball in the own frame, predicted to the moment when this tick's commands take effect.
struct Ball {
  bool known = false;                    ///< false until a camera saw it, and when it was lost for long
  Vector2d position = Vector2d::Zero();  ///< [m]
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  double height = 0;                     ///< [m] above its resting place
  double climb = 0;                      ///< [m/s] upwards, while it flies
  bool flies = false;      ///< kicked into the air and not yet rolling, as far as the filter knows
  bool bounced = false;    ///< flies, and has landed since its kick
  double rolls_below = 0;  ///< [m/s] slower than this it rolls, faster it slides (5/7 of the kick's speed)
  double unseen = 0;       ///< [s] since a camera saw it
};

/// A robot in the own frame, predicted like the ball.
struct Robot {
  std::uint8_t number = 0;
  Vector2d position = Vector2d::Zero();  ///< [m] centre
  double orientation = 0;                ///< [rad] 0 = towards the opponents' goal
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;           ///< [rad/s]
  bool ball_in_reach = false;            ///< the tracker's opinion
  bool ball_contact = false;             ///< the robot's own break beam; always false for opponents
  world::RobotSpecs specs;  ///< own: the true limits after any handicap; opponents: the usual ones
};

/// What the game asks of us now.
enum class Phase : std::uint8_t {
  Halt,            ///< nobody moves
  Stop,            ///< slow, away from the ball; also after a goal
  Timeout,         ///< anything goes, the ball is dead
  PrepareKickoff,  ///< take places; do not kick yet
  Kickoff,         ///< `ours` says who must kick
  PreparePenalty,
  Penalty,
  DirectFree,
  IndirectFree,
  Running,  ///< the ball is in play
};
const char* name(Phase phase);

/// The referee's message in our own terms.
struct Game {
  Phase phase = Phase::Halt;
  bool ours = false;                             ///< the kick of this phase belongs to us
  double age = 0;                                ///< [s] since the referee's last command
  std::optional<double> time_left;               ///< [s] to take the kick
  std::optional<Vector2d> designated_position;   ///< [m] where the ball goes
  Vector2d restart_position = Vector2d::Zero();  ///< [m] the ball when the present restart was signalled
  /// Our kicker after a restart, until another robot touched the ball: must not touch it again.
  std::optional<std::uint8_t> forbidden;
  /// an indirect kick was taken and nobody else has touched the ball yet: no direct goal
  bool indirect = false;
  int own_score = 0;
  int their_score = 0;
  int own_keeper = 0;
  int their_keeper = 0;
  int max_robots = 6;
};

/// Everything a team may know, seen with its own goal at -x: a team that defends +x sees the field turned by
/// 180 degrees, so the same decision serves both ends.
struct View {
  std::int64_t tick = 0;
  double time = 0;  ///< [s] match time of this tick
  world::Geometry geometry;
  Ball ball;
  std::vector<Robot> own;        ///< sorted by number
  std::vector<Robot> opponents;  ///< sorted by number
  Game game;

  const world::Field& field() const { return geometry.field; }
  Vector2d own_goal() const { return {-field().half_length(), 0}; }
  Vector2d their_goal() const { return {field().half_length(), 0}; }
};

/// The robot of that number, or null.
const Robot* find(const std::vector<Robot>& robots, int number);

/// The ball lies at the robot's dribbler: by the break beam or, failing that, by position.
bool holds_ball(const Robot& robot, const Ball& ball, double ball_radius);

}  // namespace kit
