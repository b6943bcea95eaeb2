#include <cmath>

#include "sim/wire/robot_control.h"

namespace wire {

namespace {

/// A finite, positive value replaces the default.
void take(bool present, float value, double& result) {
  if (present && std::isfinite(value) && value > 0) result = value;
}

}  // namespace

void encode(const world::RobotSpecs& specs, proto::RobotSpecs& out) {
  out.Clear();
  out.mutable_id()->set_id(specs.id.number);
  out.mutable_id()->set_team(specs.id.team == world::Team::Yellow ? matchday::simulation::YELLOW
                                                                  : matchday::simulation::BLUE);
  out.set_radius(static_cast<float>(specs.radius));
  out.set_height(static_cast<float>(specs.height));
  out.set_mass(static_cast<float>(specs.mass));
  out.set_max_linear_kick_speed(static_cast<float>(specs.max_kick_speed));
  out.set_max_chip_kick_speed(static_cast<float>(specs.max_chip_speed));
  out.set_center_to_dribbler(static_cast<float>(specs.center_to_dribbler));
  proto::RobotLimits& limits = *out.mutable_limits();
  limits.set_acc_speedup_absolute_max(static_cast<float>(specs.max_acceleration));
  limits.set_acc_speedup_angular_max(static_cast<float>(specs.max_angular_acceleration));
  limits.set_acc_brake_absolute_max(static_cast<float>(specs.max_brake));
  limits.set_acc_brake_angular_max(static_cast<float>(specs.max_angular_acceleration));
  limits.set_vel_absolute_max(static_cast<float>(specs.max_speed));
  limits.set_vel_angular_max(static_cast<float>(specs.max_angular_speed));
}

std::optional<world::RobotSpecs> decode(const proto::RobotSpecs& specs) {
  const matchday::simulation::RobotId& id = specs.id();
  const bool known = id.has_id() && id.id() <= world::max_robot_number &&
                     (id.team() == matchday::simulation::YELLOW || id.team() == matchday::simulation::BLUE);
  if (!known) return std::nullopt;

  world::RobotSpecs result;
  result.id = {id.team() == matchday::simulation::YELLOW ? world::Team::Yellow : world::Team::Blue,
               static_cast<std::uint8_t>(id.id())};
  take(specs.has_radius(), specs.radius(), result.radius);
  take(specs.has_height(), specs.height(), result.height);
  take(specs.has_mass(), specs.mass(), result.mass);
  take(specs.has_max_linear_kick_speed(), specs.max_linear_kick_speed(), result.max_kick_speed);
  take(specs.has_max_chip_kick_speed(), specs.max_chip_kick_speed(), result.max_chip_speed);
  take(specs.has_center_to_dribbler(), specs.center_to_dribbler(), result.center_to_dribbler);
  const proto::RobotLimits& limits = specs.limits();
  take(limits.has_acc_speedup_absolute_max(), limits.acc_speedup_absolute_max(), result.max_acceleration);
  take(limits.has_acc_speedup_angular_max(), limits.acc_speedup_angular_max(),
       result.max_angular_acceleration);
  take(limits.has_acc_brake_absolute_max(), limits.acc_brake_absolute_max(), result.max_brake);
  take(limits.has_vel_absolute_max(), limits.vel_absolute_max(), result.max_speed);
  take(limits.has_vel_angular_max(), limits.vel_angular_max(), result.max_angular_speed);
  return result;
}

}  // namespace wire
