#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/physics/params.h"
#include "sim/vision/params.h"
#include "sim/world/robot_specs.h"

namespace engine {

/// The radio between team and robots.
struct RadioParams {
  int latency = 1;  ///< [ticks] the commands given to step k move the robots in step k + latency
  double loss = 0;  ///< probability that a robot does not hear its command of one tick
  /// [ticks] a robot that heard nothing goes on for so long, without kicking, and then
  /// stops (0.1 s: ER-Force)
  int timeout = 6;
};

/// How the simulated world differs from a perfect one: a preset with a name, any number
/// of which can be changed.
struct Realism {
  std::string name;
  vision::Params vision;  ///< cameras: noise, loss, delay
  RadioParams radio;
  physics::Params physics;   ///< ball, contacts, actuator errors
  world::RobotSpecs robots;  ///< every robot before its handicap; the id does not matter
};

/// The preset of that name: "none", "friendly", "measured" or "harsh".
///
/// @throws std::invalid_argument naming the known presets
const Realism& realism(std::string_view name);

/// All presets, from the kindest to the hardest.
std::span<const Realism> realism_presets();

/// A number of a Realism that can be changed by its name.
struct RealismKey {
  std::string_view name;  ///< as in designs: "vision.ball_sigma"
  std::string_view unit;  ///< "m", "rad/s", "" for a count, share or probability
  double lowest = 0;
  double highest = 0;
  bool whole = false;        ///< takes whole numbers only
  std::string_view meaning;  ///< one line
  double (*get)(const Realism&) = nullptr;
  void (*put)(Realism&, double) = nullptr;  ///< unchecked; use `set`
};

/// All keys, in the order of the structs.
std::span<const RealismKey> realism_keys();

/// Changes one number.
///
/// @throws std::invalid_argument naming key, value and range; for an unknown key also the
///         most similar known one
void set(Realism& realism, std::string_view key, double value);

}  // namespace engine
