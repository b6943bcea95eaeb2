#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/world/game_state.h"

namespace referee {

// What the operator can do (R-8-7). See Referee::overrule.

/// The last decision that stopped play was wrong: its goal and its card are taken back, and play goes on with
/// a neutral start from where the ball was, or, when a kick had been stopped, with that kick. Law 5 allows
/// that until play has been restarted.
struct ReverseLastCall {};

/// A command, whatever the robots are doing.
/// - The kick that is due is sent at once. Another kick, kickoff or penalty becomes the one that is due,
///   after a STOP if play was on.
/// - HALT, STOP, START and READY are sent at once.
/// - GOAL(T) awards a goal to T.
/// - TIMEOUT(T) takes one of T's time-outs.
struct ForceCommand {
  world::Command command;
};

struct SetScore {
  world::PerTeam<int> score{};
};

/// The cards of one team as they shall be from now on.
struct SetCards {
  world::Team team{};
  int red = 0;
  std::vector<world::Duration> yellow;  ///< time left of each
};

/// Play is stopped and the stage begins: a PRE stage with its kickoff, a half with its full time, a break
/// with HALT, the shoot-out with its next kick, POST with the end of the game.
struct SetStage {
  world::Stage stage{};
};

/// Where the ball is put for the restart that is due [m].
struct SetBallPosition {
  world::Vector2d position = world::Vector2d::Zero();
};

/// HALT until Resume; no clock runs.
struct Pause {};
/// STOP, and the restart that was interrupted comes next.
struct Resume {};

/// One act of the operator.
struct Override {
  std::string who;  ///< name of the operator
  std::string why;  ///< for the log; one line
  std::variant<ReverseLastCall, ForceCommand, SetScore, SetCards, SetStage, SetBallPosition, Pause, Resume>
      what;
};

}  // namespace referee
