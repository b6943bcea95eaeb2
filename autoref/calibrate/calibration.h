#pragma once

#include <optional>

#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"
#include "sim/world/field.h"

namespace calibrate {

/// What a log tells of cameras, ball and robots, as a realism preset.
///
/// @param geometry  of the log, for the places of the cameras; nothing: these are left out
Report calibrated(const Observations& seen, const std::optional<world::Geometry>& geometry);

}  // namespace calibrate
