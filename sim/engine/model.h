#pragma once

#include <cstdint>
#include <vector>

#include "sim/engine/realism.h"
#include "sim/world/field.h"
#include "sim/world/robot_specs.h"

namespace engine {

/// Everything about a match that does not change while it is played.
struct Model {
  world::Geometry geometry;                               ///< without cameras: one over each quarter
  world::PerTeam<std::vector<world::RobotSpecs>> robots;  ///< handicaps already applied (world::slowed)
  bool blue_on_positive_half = true;                      ///< blue starts in the half of +x
  Realism realism;
  std::uint64_t seed = 0;
};

/// Robots of a team by number, all with the body and limits of `body` (its id does not matter),
/// slowed by `speed_factor`.
///
/// @throws std::invalid_argument when speed_factor is not in (0, 10]
std::vector<world::RobotSpecs> standard_robots(world::Team team, const std::vector<int>& numbers,
                                               double speed_factor = 1, const world::RobotSpecs& body = {});

/// Checks a model before it is used.
///
/// @throws std::invalid_argument naming team, robot, field and value: more than 16 robots,
///         a number above 15 or used twice, a robot of the other team, a limit that is not positive and
///         finite, an impossible field
void check(const Model& model);

}  // namespace engine
