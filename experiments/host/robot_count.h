#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/engine/engine.h"
#include "sim/world/game_state.h"
#include "sim/world/referee_message.h"

namespace host {

/// Takes robots off the field that a card forbids, and lets them back in.
///
/// In GAME_OFF only (DESIGN, "Clock, stages, stoppages"): the highest number first, never the keeper, or the
/// one the team names; they come back at the halfway line, outside the touch line.
class RobotCount {
 public:
  void update(const world::RefereeMessage& message, const world::GameState& state, engine::Engine& engine);

  /// The team's choice of who leaves next.
  void prefer(world::RobotId robot) { preferred_[robot.team] = robot.number; }

 private:
  world::PerTeam<std::vector<std::uint8_t>> outside_;
  world::PerTeam<std::optional<std::uint8_t>> preferred_;
};

}  // namespace host
