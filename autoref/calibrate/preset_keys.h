#pragma once

#include <span>
#include <string_view>

namespace calibrate {

/// A number of a realism preset that a log can tell: the simulator's name and range for it.
struct PresetKey {
  std::string_view name;  ///< "vision.ball_sigma"
  double lowest;
  double highest;
  bool whole;  ///< takes whole numbers only
};

/// All of them, in the order of the simulator's list, of which tests hold them to be a part.
std::span<const PresetKey> preset_keys();

/// @throws std::invalid_argument for a name that is none of them
const PresetKey& preset_key(std::string_view name);

}  // namespace calibrate
