#pragma once

#include <optional>

#include "sim/engine/engine.h"
#include "sim/world/game_state.h"

namespace host {

/// Puts the ball where the referee wishes, when people with a stick in their hand would.
///
/// At least 0.5 s after the command that stopped play, and not before every hull is 0.15 m away from the
/// spot; after 3 s anyway, with the robots that stand there moved out.
///
/// Source  DESIGN, "Clock, stages, stoppages"
class BallReset {
 public:
  static constexpr double clearance = 0.15;                                 ///< [m] hull to the ball's centre
  static constexpr world::Duration delay = std::chrono::milliseconds{500};  ///< after STOP or GOAL
  static constexpr world::Duration patience = std::chrono::seconds{3};      ///< after the wish

  /// @param wish     of the referee in this tick, if any
  /// @param state    of the referee
  /// @param engine   after the step of this tick
  /// @return where the ball was put in this tick, if it was
  std::optional<world::Vector2d> update(const std::optional<world::Vector2d>& wish,
                                        const world::GameState& state, engine::Engine& engine);

 private:
  struct Wish {
    world::Vector2d spot = world::Vector2d::Zero();  // [m]
    world::Time since;
  };
  std::optional<Wish> wish_;
};

}  // namespace host
