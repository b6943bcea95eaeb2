#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "sim/engine/engine.h"
#include "sim/server/pull.h"
#include "sim/server/setup.h"
#include "sim/wire/problem.h"
#include "sim/wire/robot_control.h"
#include "sim/wire/simulator_command.h"
#include "sim/world/detection.h"

namespace server {

/// The engine as the simulation protocol wants it: robots come and go, bodies are teleported and dragged,
/// commands hold for a while, and everything constant can be exchanged while time goes on.
class Simulation {
 public:
  static constexpr int command_life = 6;  ///< [ticks] 0.1 s: a robot without a new command stops (ER-Force)

  /// @param robots  numbers of those on the field at first, lined up in their own halves
  /// @throws std::invalid_argument, see `check(const Setup&)`
  Simulation(const Setup& setup, const world::PerTeam<std::vector<int>>& robots);

  const Setup& setup() const { return setup_; }

  /// Goes on with another set-up: a new engine, in which ball and robots are where they were and move as they
  /// did, or at the wall where that is outside now. What was on its way to teams and robots is lost. When it
  /// makes the same world, the engine stays.
  /// @throws std::invalid_argument; then nothing has changed
  void reconfigure(const Setup& setup);

  /// Each obeys or says why not; then nothing has changed.
  std::optional<wire::Problem> teleport(const wire::BallTeleport& wish);
  std::optional<wire::Problem> teleport(const wire::RobotTeleport& wish);
  /// Holds for `command_life` ticks from the next one on, or until the next order for the same robot.
  std::optional<wire::Problem> order(world::Team team, const wire::RobotOrder& order);

  /// Advances by one tick of 1/60 s.
  void step();

  std::int64_t tick() const { return first_tick_ + engine_.tick(); }
  world::Time time() const { return world::tick_time(tick()); }
  /// What arrived from the cameras in the last step, in the time of this class.
  std::span<const world::Detection> detections() const { return detections_; }
  const truth::Frame& truth() const { return engine_.truth(); }  ///< its tick and times are the engine's
  const world::Geometry& geometry() const { return engine_.model().geometry; }
  std::size_t robots_on_field() const { return engine_.truth().robots.size(); }

 private:
  struct HeldOrder {
    wire::RobotOrder order;
    std::int64_t last_tick = -1;  // in which it still counts
  };

  const truth::Robot* find(world::RobotId id) const;
  world::Vector2d inside(const world::Vector2d& position, double radius) const;
  std::optional<wire::Problem> outside_walls(const char* what, const world::Vector2d& position,
                                             double radius) const;
  void drag();
  world::RobotCommand command(const wire::RobotOrder& order, const truth::Robot& robot) const;
  void collect_detections();

  Setup setup_;
  engine::Engine engine_;
  std::int64_t first_tick_ = 0;  // of the present engine
  world::PerTeam<std::array<HeldOrder, robots_per_team>> orders_;
  std::optional<world::Vector3d> ball_pull_;  // [m]
  std::map<world::RobotId, RobotPull> robot_pulls_;
  std::vector<world::Detection> detections_;
  std::map<int, std::uint32_t> next_frame_;  // by camera
};

}  // namespace server
