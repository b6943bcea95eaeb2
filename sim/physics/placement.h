#pragma once

#include <span>
#include <vector>

#include "sim/physics/fixtures.h"
#include "sim/world/robot_specs.h"

namespace physics {

/// A robot's place on the field.
struct Placed {
  const world::RobotSpecs* specs = nullptr;
  world::Vector2d position = world::Vector2d::Zero();  ///< [m]
  double orientation = 0;                              ///< [rad]
};

/// Moves the robots whose hull is within `clearance` [m] of `spot` out of the way; orientations stay.
///
/// Each goes radially by the least distance. Where a wall, a goal or another robot is in the way,
/// it takes the free place at that clearance or farther that is nearest to where it stood (searched in
/// steps of 5 degrees and 20 mm, up to 1 m away). Where there is none, it goes radially all the same,
/// but stays inside the walls.
///
/// @return  for each robot, whether it was moved
std::vector<bool> push_out(std::vector<Placed>& robots, std::span<const Fixture> fixtures,
                           const world::Field& field, const world::Vector2d& spot, double clearance);

}  // namespace physics
