#include "sim/physics/actuators.h"

#include <algorithm>

#include "sim/world/random.h"

namespace physics {
namespace {

double drawn(world::RandomStream& stream) { return std::clamp(stream.gaussian(), -3.0, 3.0); }

}  // namespace

Actuators::Actuators(const ActuatorErrors& errors, world::RobotId id, std::uint64_t seed)
    : errors_(errors),
      seed_(world::derived_seed(
          seed, "actuators " + std::string(name(id.team)) + " " + std::to_string(id.number))) {
  world::RandomStream stream(seed_, "drive");
  speed_factor_ = 1 + errors.speed_sigma * drawn(stream);
  acceleration_factor_ = 1 + errors.acceleration_sigma * drawn(stream);
  heading_drift_ = errors.heading_drift_sigma * drawn(stream);
}

KickError Actuators::kick(int number) const {
  const ActuatorErrors& e = errors_;
  if (e.kick_direction_sigma == 0 && e.kick_speed_sigma == 0 && e.chip_angle_sigma == 0 && e.misfire == 0) {
    return {};
  }
  world::RandomStream stream(seed_, "kick " + std::to_string(number));
  KickError error;
  error.misfires = stream.uniform() < e.misfire;
  error.direction = e.kick_direction_sigma * drawn(stream);
  error.speed_factor = 1 + e.kick_speed_sigma * drawn(stream);
  error.chip_angle = e.chip_angle_sigma * drawn(stream);
  return error;
}

double Actuators::grip_factor(int number) const {
  if (errors_.grip_sigma == 0) return 1;
  world::RandomStream stream(seed_, "capture " + std::to_string(number));
  return std::max(1 + errors_.grip_sigma * drawn(stream), 0.0);
}

}  // namespace physics
