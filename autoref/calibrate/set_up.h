#pragma once

#include <optional>

#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"
#include "sim/world/field.h"

namespace calibrate {

/// Cameras: how many, how high, how far they see into each other's part, at what rate and with what delay;
/// and how many robots there were. Places of cameras come from the log's geometry.
void add_set_up(const Observations& seen, const std::optional<world::Geometry>& geometry, Report& report);

}  // namespace calibrate
