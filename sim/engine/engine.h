#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "sim/engine/model.h"
#include "sim/truth/truth.h"
#include "sim/world/detection.h"
#include "sim/world/robot_command.h"

namespace vision {
class Cameras;
}

namespace engine {

/// Where the time of a step goes; nothing in the simulation depends on it.
struct Timing {
  std::chrono::steady_clock::duration vision{};  ///< the cameras' share, summed up
};

/// Everything that changes in an Engine, at one moment. Belongs to one Model; may be kept, copied, restored
/// any number of times. (A whole game is kept otherwise: experiments/host, recorded games.)
class Snapshot {
 public:
  Snapshot(const Snapshot&);
  Snapshot& operator=(const Snapshot&);
  Snapshot(Snapshot&&) noexcept;
  Snapshot& operator=(Snapshot&&) noexcept;
  ~Snapshot();

 private:
  friend class Engine;
  struct Values;
  explicit Snapshot(std::unique_ptr<Values> values);
  std::unique_ptr<Values> values_;
};

/// The simulator: a constant Model, a State that changes, and `step`.
///
/// Nothing is called back; after a step read `truth()` and `detections()`.
/// The same model and the same commands give the same bits, in this process and in another one of the same
/// binary on the same class of CPU.
class Engine {
 public:
  /// Robots start in a line-up in their own half, one of each team in its goal mouth,
  /// the ball at the centre mark.
  ///
  /// @throws std::invalid_argument, see `check(const Model&)`
  explicit Engine(Model model);
  ~Engine();
  Engine(Engine&&) noexcept;
  Engine& operator=(Engine&&) noexcept;

  const Model& model() const;

  /// Advances the world by one tick (4 substeps of 1/240 s).
  ///
  /// Commands are delayed by `RadioParams::latency`: those of step k move the robots in step k + latency.
  /// - A robot that does not hear its command (RadioParams::loss) goes on with the one before for a while.
  /// - A robot that is not in its team's commands stops (zero velocity, no kick, dribbler off).
  /// - Commands for robots that do not exist, and numbers that are not finite, count as nothing.
  /// - Of two commands for one robot the last one counts.
  void step(const world::PerTeam<world::TeamCommands>& commands);

  /// Other cameras on the same world: from now on they take their images at the same instants as the
  /// model's own. Nothing in the simulation depends on them; they must outlive the engine.
  void also_seen_by(vision::Cameras& cameras);

  /// Adds to `timing` from now on; null, as at first: no clock is read.
  void measure(Timing* timing);

  std::int64_t tick() const;  ///< after n steps: n
  world::Time time() const;   ///< after n steps: tick_time(n)

  /// Poses now; contacts and kicks of the last step.
  const truth::Frame& truth() const;

  /// What arrived at the end of the last step (vision delay applied), in the order of capture.
  std::span<const world::Detection> detections() const;

  /// Everything that changes: bodies, actuators, radio, cameras, what is on its way, all random streams.
  Snapshot snapshot() const;

  /// Goes on from a snapshot of an Engine of the same model.
  ///
  /// Every continuation with the same commands is alike to the bit. It equals the original's too, unless
  /// bodies touched at that moment: Bullet's contact caches start anew.
  ///
  /// @throws std::invalid_argument when the model has other robots or another latency
  void restore(const Snapshot& snapshot);

  /// Puts the ball on the ground there, at rest and without spin; contact caches are cleared.
  /// Robots in the way stay: see `push_robots_out`. They are pushed off by the physics, without energy.
  void place_ball(const world::Vector2d& spot);

  /// Puts the ball somewhere with a motion of its own; contact caches are cleared.
  void put_ball(const truth::Ball& ball);

  /// Says whether no robot's hull is within `clearance` [m] of the point `spot`.
  bool spot_is_free(const world::Vector2d& spot, double clearance) const;

  /// Moves robots whose hull is within `clearance` [m] of `spot` out radially by the least distance, to rest,
  /// inside the walls and off goals and other robots where possible.
  void push_robots_out(const world::Vector2d& spot, double clearance);

  /// Takes a robot off the field; nothing happens when it is not there.
  void remove_robot(world::RobotId id);

  /// Puts a robot of the model at a place, on or off the field so far, with a motion [m/s, rad/s] or at rest.
  /// @throws std::invalid_argument when the model has no such robot
  void put_robot(world::RobotId id, const world::Vector2d& position, double orientation,
                 const world::Vector2d& velocity = world::Vector2d::Zero(), double angular_velocity = 0);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace engine
