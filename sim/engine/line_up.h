#pragma once

#include <vector>

#include "sim/world/field.h"
#include "sim/world/robot_id.h"

namespace engine {

/// A robot's place.
struct Pose {
  world::Vector2d position = world::Vector2d::Zero();  ///< [m]
  double orientation = 0;                              ///< [rad]
};

/// Where `count` robots (up to 16) of the team that defends `side` stand before the match, all in their own
/// half, facing the other: the first in its goal mouth, the others in rows of five from 1 m before the
/// halfway line backwards.
std::vector<Pose> line_up(const world::Field& field, world::Side side, std::size_t count);

}  // namespace engine
