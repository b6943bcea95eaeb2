#pragma once

#include <array>
#include <optional>

#include "sim/proto/simulation.pb.h"
#include "sim/wire/problem.h"
#include "sim/world/geometry.h"
#include "sim/world/robot_id.h"

namespace wire {

/// What is not said stays as it is.
struct BallTeleport {
  std::array<std::optional<double>, 3> position;  ///< [m] x, y, and z above the resting height
  std::array<std::optional<double>, 3> velocity;  ///< [m/s]
  bool safely = false;                            ///< push robots out of the way
  bool roll = false;                              ///< with the spin of pure rolling
  bool by_force = false;  ///< drag it to `position` until another message comes; velocities do not count

  bool says_where() const { return position[0] || position[1] || position[2]; }
  bool says_how_fast() const { return velocity[0] || velocity[1] || velocity[2]; }
};

/// A place that is not said stays as it is; a motion that is not said is zero.
struct RobotTeleport {
  world::RobotId id;
  std::array<std::optional<double>, 2> position;       ///< [m]
  std::optional<double> orientation;                   ///< [rad]
  world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;                         ///< [rad/s]
  bool says_how_fast = false;                          ///< one of these numbers was there
  std::optional<bool> present;                         ///< true: create it if missing; false: remove it
  bool by_force = false;                               ///< drag it there until another message comes

  bool says_where() const { return position[0] || position[1] || orientation; }
};

/// From the wire. A problem is a robot id that is missing or unknown, and a number that is not finite or
/// absurd: positions beyond 100 m, speeds beyond 10 m/s (what the walls are proven to hold), turning beyond
/// 100 rad/s, a ball below its resting height or more than 5 m above. Whether the place is inside the walls
/// is the simulator's business.
Result<BallTeleport> decode(const matchday::simulation::TeleportBall& message);
Result<RobotTeleport> decode(const matchday::simulation::TeleportRobot& message);

}  // namespace wire
