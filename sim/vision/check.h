#pragma once

#include "sim/vision/params.h"
#include "sim/world/field.h"
#include "sim/world/robot_specs.h"

namespace vision {

/// Checks what a `Cameras` is made of.
///
/// @throws std::invalid_argument  one sentence naming camera or parameter, value and what is possible
void check(const world::Geometry& geometry, const Params& params, const world::RobotSpecs& body);

}  // namespace vision
