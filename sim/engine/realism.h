#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/vision/params.h"

namespace engine {

/// How far sensors and radio are from perfect: a preset with a name.
struct Realism {
  std::string name;
  vision::Params vision;    ///< noise, loss, delay of the cameras
  int command_latency = 1;  ///< [ticks] the commands given to step k move the robots in step k + latency
};

/// The preset of that name: "none", "friendly", "measured" or "harsh".
///
/// @throws std::invalid_argument naming the known presets
const Realism& realism(std::string_view name);

/// All presets, from the kindest to the hardest.
std::span<const Realism> realism_presets();

}  // namespace engine
