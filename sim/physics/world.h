#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "sim/physics/params.h"
#include "sim/physics/state.h"
#include "sim/truth/truth.h"
#include "sim/world/field.h"
#include "sim/world/robot_command.h"
#include "sim/world/robot_specs.h"

namespace physics {

/// Robots, ball, walls and goals as bodies; advances in substeps (of 1/240 s by default).
///
/// Rigid-body collisions are Bullet's (single precision, real scale); drive, kicker, dribbler and the ball's
/// contact with the carpet are closed forms applied round each of its steps. Positions come from velocities
/// in the middle of a substep, so that free motion under constant acceleration is exact.
class World {
 public:
  /// @param seed    of the match, for the actuators' errors
  /// @param robots  all robots that may ever be on the field, sorted by id, ids unique; none is on it yet
  World(const world::Field& field, std::span<const world::RobotSpecs> robots, const Params& params = {},
        std::uint64_t seed = 0);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  std::size_t robot_count()
      const;  ///< as given to the constructor; robots are addressed by their index there
  const world::RobotSpecs& specs(std::size_t robot) const;
  bool is_present(std::size_t robot) const;

  /// What the robot does from the next substep on.
  /// @pre all numbers finite
  void set_command(std::size_t robot, const world::RobotCommand& command);

  /// Advances by one substep (1/240 s by default); appends what happened, with `end` as its time.
  void substep(world::Time end, std::vector<truth::Contact>& contacts, std::vector<truth::Kick>& kicks);

  const truth::Ball& ball() const;
  /// Overwrites `out` with the robots on the field, sorted by id.
  void read_robots(std::vector<truth::Robot>& out) const;

  /// Puts the ball somewhere with a motion of its own, or (by default) at rest; contact caches are cleared.
  void place_ball(const truth::Ball& ball);
  /// At rest on the carpet.
  void place_ball(const world::Vector2d& spot);

  /// Puts a robot on the field, or moves it, at rest; its contact caches, charge and command are cleared.
  void put_robot(std::size_t robot, const world::Vector2d& position, double orientation);
  /// Gives a robot on the field a motion, for tests and restored states.
  void set_motion(std::size_t robot, const world::Vector2d& velocity, double angular_velocity);
  void remove_robot(std::size_t robot);

  /// All that changes, as plain values.
  State state() const;
  /// Goes on from a state of a World with the same constructor arguments, in whatever state this one is.
  ///
  /// Contact caches and everything else that has a history start anew, so all Worlds that restore a state
  /// continue alike to the bit. With the World the state was taken from they agree to the bit as long as
  /// nothing touches; a touch at that moment may differ by the contact's warm start.
  ///
  /// @pre as many robots as this World has
  void restore(const State& state);

  /// Distance from the hulls of the robots on the field to a point, the smallest [m];
  /// infinite without robots.
  double distance_to_robots(const world::Vector2d& point) const;

  /// See Engine::push_robots_out.
  void push_robots_out(const world::Vector2d& spot, double clearance);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace physics
