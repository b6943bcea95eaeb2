#pragma once

#include <vector>

#include "sim/world/field.h"

namespace physics {

/// A box that does not move, with sides along the field's axes.
struct Fixture {
  enum class Kind { Wall, GoalSide, GoalBack, GoalRoof };
  Kind kind{};
  world::Vector3d min = world::Vector3d::Zero();  ///< [m]
  world::Vector3d max = world::Vector3d::Zero();  ///< [m]
};

/// Walls round the run-off, and two goals of two sides, a back and a roof each.
///
/// Inner faces are where the laws put them. Walls are 0.2 m thick and 3 m high; goal sides and backs are
/// thickened outward to 45 and 60 mm, because a ball at 10 m/s enters up to 20 mm within one substep and must
/// not pass the middle of what it hit. The roof begins at the crossbar's underside.
std::vector<Fixture> fixtures(const world::Field& field);

/// Distance in the plane from a fixture to a point [m]; 0 inside.
double plane_distance(const Fixture& fixture, const world::Vector2d& point);

}  // namespace physics
