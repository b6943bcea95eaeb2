#pragma once

#include <vector>

#include "sim/world/geometry.h"
#include "sim/world/robot_specs.h"

namespace physics {

/// Distance from a robot's hull (disc with a flat front) to a point [m], both in the robot's
/// frame; negative inside.
double hull_distance_local(const world::RobotSpecs& specs, const world::Vector2d& point_local);

/// The same for a robot at a place of the field.
double hull_distance(const world::RobotSpecs& specs, const world::Vector2d& position, double orientation,
                     const world::Vector2d& point);

/// Corners of the hull in the robot's frame [m], counter-clockwise from the right end of the flat front: the
/// flat front and `segments` straight pieces that cross the nominal radius (with 14, corners stick out by
/// 0.7 mm and the middles of the pieces lie 0.7 mm inside), all of it `inset` [m] inside.
std::vector<world::Vector2d> hull_corners(const world::RobotSpecs& specs, int segments, double inset);

}  // namespace physics
