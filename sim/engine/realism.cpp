#include "sim/engine/realism.h"

#include <array>
#include <stdexcept>

namespace engine {
namespace {

// Delay and latency: DESIGN, "One tick of a game". `measured`: measured on a league log. `friendly`, `harsh`:
// ER-Force's "Friendly" and "Realistic" (reference "physics", section 4), but that `friendly` loses nothing.
const std::array<Realism, 4>& presets() {
  static const std::array<Realism, 4> all = {{
      {"none", {}, 1},
      {"friendly", {.ball_sigma = 0.0004, .robot_sigma = 0.0003, .orientation_sigma = 0.003}, 1},
      {"measured",
       {.ball_sigma = 0.0005, .robot_sigma = 0.00055, .orientation_sigma = 0.0035, .delay = 1},
       1},
      {"harsh",
       {.ball_sigma = 0.0014,
        .robot_sigma = 0.0013,
        .orientation_sigma = 0.01,
        .ball_missing = 0.05,
        .robot_missing = 0.02,
        .delay = 1},
       2},
  }};
  return all;
}

}  // namespace

const Realism& realism(std::string_view name) {
  std::string known;
  for (const Realism& preset : presets()) {
    if (preset.name == name) return preset;
    known += (known.empty() ? "" : ", ") + preset.name;
  }
  throw std::invalid_argument("realism: no preset is named \"" + std::string(name) + "\"; known are " +
                              known);
}

std::span<const Realism> realism_presets() { return presets(); }

}  // namespace engine
