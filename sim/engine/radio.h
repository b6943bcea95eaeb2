#pragma once

#include <cstdint>

#include "sim/engine/realism.h"
#include "sim/world/random.h"
#include "sim/world/robot_command.h"
#include "sim/world/robot_id.h"

namespace engine {

/// One robot's receiver: which command the robot follows when some are lost on the way.
///
/// A robot that nobody sends to stops at once, since a team's reply names all it wants to move. A robot whose
/// command is lost goes on with the last one it heard, without kicking, until RadioParams::timeout.
class RobotRadio {
 public:
  RobotRadio(world::RobotId id, const RadioParams& params, std::uint64_t match_seed);

  /// Call first in every tick; draws whether this tick's command will be lost.
  void begin_tick();
  /// The command that was sent for this tick; of two the last one counts.
  void send(const world::RobotCommand& command);
  /// What the robot does in this tick.
  const world::RobotCommand& heard() const { return command_; }

 private:
  RadioParams params_;
  world::RandomStream stream_;
  world::RobotCommand stop_;
  world::RobotCommand last_;     // heard
  world::RobotCommand command_;  // in effect
  int silent_ = 0;               // [ticks] without hearing anything
  bool lost_ = false;
};

}  // namespace engine
