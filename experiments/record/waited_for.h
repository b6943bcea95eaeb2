#pragma once

#include <string>

#include "sim/world/robot_id.h"

namespace record {

/// The key among a game's costs that says: it is void because the machine seemed too slow while the host waited
/// for this team.
inline std::string waited_for(world::Team team) { return std::string("waited_for_") + world::name(team); }

}  // namespace record
