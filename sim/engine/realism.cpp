#include "sim/engine/realism.h"

#include <array>
#include <stdexcept>

namespace engine {
namespace {

// Every number's source: README, "Presets".
Realism none() {
  Realism realism;
  realism.name = "none";
  return realism;
}

Realism friendly() {
  Realism realism;
  realism.name = "friendly";
  realism.vision.ball_sigma = 0.0004;
  realism.vision.robot_sigma = 0.0003;
  realism.vision.orientation_sigma = 0.003;
  realism.vision.area_sigma = 1;
  return realism;
}

Realism measured() {
  Realism realism;
  realism.name = "measured";
  realism.vision.delay = 1;
  realism.vision.ball_sigma = 0.0005;
  realism.vision.robot_sigma = 0.00055;
  realism.vision.orientation_sigma = 0.0035;
  realism.vision.bias_sigma = 0.010;
  realism.vision.area_sigma = 6.5;
  realism.vision.visible_share = 0.4;
  physics::ActuatorErrors& actuators = realism.physics.actuators;
  actuators.kick_direction_sigma = 0.02;
  actuators.kick_speed_sigma = 0.03;
  actuators.chip_angle_sigma = 0.03;
  actuators.misfire = 0.005;
  actuators.grip_sigma = 0.1;
  actuators.speed_sigma = 0.01;
  actuators.acceleration_sigma = 0.03;
  actuators.heading_drift_sigma = 0.01;
  return realism;
}

Realism harsh() {
  Realism realism = measured();
  realism.name = "harsh";
  vision::Params& vision = realism.vision;
  vision.ball_sigma = 0.0014;
  vision.robot_sigma = 0.0014;
  vision.orientation_sigma = 0.01;
  vision.ball_missing = 0.05;
  vision.robot_missing = 0.02;
  vision.ball_burst_start = 0.002;
  vision.ball_burst_length = 15;
  vision.robot_burst_start = 0.0005;
  vision.robot_burst_length = 10;
  vision.regions = 1;
  vision.region_missing = 0.3;
  vision.region_offset = 0.02;
  vision.false_ball_rate = 0.02;
  vision.misread_id = 0.0005;
  vision.unread_id = 0.0005;
  realism.radio.latency = 2;
  realism.radio.loss = 0.03;
  physics::ActuatorErrors& actuators = realism.physics.actuators;
  for (double* scatter :
       {&actuators.kick_direction_sigma, &actuators.kick_speed_sigma, &actuators.chip_angle_sigma,
        &actuators.misfire, &actuators.grip_sigma, &actuators.speed_sigma, &actuators.acceleration_sigma,
        &actuators.heading_drift_sigma}) {
    *scatter *= 2;
  }
  return realism;
}

const std::array<Realism, 4>& presets() {
  static const std::array<Realism, 4> all = {{none(), friendly(), measured(), harsh()}};
  return all;
}

}  // namespace

const Realism& realism(std::string_view name) {
  std::string known;
  for (const Realism& preset : presets()) {
    if (preset.name == name) return preset;
    known += (known.empty() ? "" : ", ") + preset.name;
  }
  throw std::invalid_argument("realism \"" + std::string(name) + "\" is not known; known are " + known);
}

std::span<const Realism> realism_presets() { return presets(); }

}  // namespace engine
