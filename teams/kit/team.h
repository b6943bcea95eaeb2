#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "sim/world/robot_command.h"
#include "teams/kit/view.h"

namespace kit {

/// What the host tells a team before the game.
struct Setup {
  world::Team team = world::Team::Yellow;
  std::string team_name;
  std::uint64_t seed = 0;
  std::string log_directory;
  std::string rules;
  world::Geometry geometry;
  std::vector<world::RobotSpecs> robots;  ///< our own, after any handicap
  int vision_delay = 0;                   ///< [ticks] from capture to arrival
  int command_latency = 0;                ///< [ticks] from reply to effect, beyond the next tick
};

/// A team's mind: looks at the world, says what its robots do. Knows nothing of sockets or sides.
class Team {
 public:
  virtual ~Team() = default;
  /// Fills `out` (empty at the call) with the commands of this tick; a robot left out stops.
  virtual void play(const View& view, world::TeamCommands& out) = 0;
  /// The robot that is to be goalkeeper; told to the referee at the start.
  virtual int keeper(const Setup& setup) const;
  /// What it was thinking, for the game's log (with --notes on).
  virtual std::string_view note() const { return {}; }
  /// One line about the whole game for the team's own log, asked for at its end; empty: nothing to say.
  virtual std::string summary() const { return {}; }
};

}  // namespace kit
