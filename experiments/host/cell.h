#pragma once

#include "experiments/host/play.h"
#include "experiments/process/isolation.h"
#include "experiments/record/match_config.h"
#include "sim/world/robot_id.h"

namespace host {

/// What a team sees of the machine: its own program and log folder, not the other team's
/// nor the result folder.
process::Cell cell_of(world::Team team, const record::MatchConfig& config, const Options& options);

}  // namespace host
