#include <fmt/format.h>

#include <cmath>
#include <string>

#include "sim/proto/simulation_custom.pb.h"
#include "sim/wire/any.h"
#include "sim/wire/robot_control.h"

namespace wire {

namespace {

/// Takes values over from one message, and notes what is bad in it.
class Reader {
 public:
  explicit Reader(std::vector<Problem>& problems) : problems_(problems) {}

  /// A finite, positive value replaces what was there.
  bool positive(const char* name, bool present, float value, double& result) {
    if (!present) return false;
    if (!std::isfinite(value) || value <= 0) {
      problems_.push_back({code::spec, fmt::format("{} = {}: must be positive and finite", name, value)});
      return false;
    }
    result = value;
    return true;
  }
  /// A limit for both directions of moving.
  void limit(const char* name, bool present, float value, double& forward, double& sideways) {
    if (positive(name, present, value, forward)) sideways = forward;
  }
  void unsupported(std::string sentence) { problems_.push_back({code::unsupported, std::move(sentence)}); }
  void bad(std::string sentence) { problems_.push_back({code::spec, std::move(sentence)}); }

 private:
  std::vector<Problem>& problems_;
};

void apply_limits(const proto::RobotLimits& limits, world::RobotSpecs& specs, Reader& reader) {
  reader.limit("vel_absolute_max", limits.has_vel_absolute_max(), limits.vel_absolute_max(), specs.max_speed,
               specs.max_speed_sideways);
  reader.limit("acc_speedup_absolute_max", limits.has_acc_speedup_absolute_max(),
               limits.acc_speedup_absolute_max(), specs.max_acceleration, specs.max_acceleration_sideways);
  reader.limit("acc_brake_absolute_max", limits.has_acc_brake_absolute_max(), limits.acc_brake_absolute_max(),
               specs.max_brake, specs.max_brake_sideways);
  reader.positive("vel_angular_max", limits.has_vel_angular_max(), limits.vel_angular_max(),
                  specs.max_angular_speed);
  reader.positive("acc_speedup_angular_max", limits.has_acc_speedup_angular_max(),
                  limits.acc_speedup_angular_max(), specs.max_angular_acceleration);
  reader.positive("acc_brake_angular_max", limits.has_acc_brake_angular_max(), limits.acc_brake_angular_max(),
                  specs.max_angular_brake);
}

void apply_wheels(const proto::RobotWheelAngles& angles, WheelAngles& wheels, Reader& reader) {
  const bool complete = angles.has_front_right() && angles.has_back_right() && angles.has_back_left() &&
                        angles.has_front_left();
  const bool finite = std::isfinite(angles.front_right()) && std::isfinite(angles.back_right()) &&
                      std::isfinite(angles.back_left()) && std::isfinite(angles.front_left());
  if (!complete || !finite) {
    reader.bad("wheel_angles: all four must be there and finite [rad, clockwise from forward]");
    return;
  }
  wheels = {angles.front_right(), angles.back_right(), angles.back_left(), angles.front_left()};
}

void apply_custom(const google::protobuf::Any& custom, world::RobotSpecs& specs, Reader& reader) {
  if (const auto ours = unpacked<proto::RobotSpecsMatchday>(custom, {"matchday.simulation."})) {
    reader.positive("dribbler_width", ours->has_dribbler_width(), ours->dribbler_width(),
                    specs.dribbler_width);
    reader.positive("vel_sideways_max", ours->has_vel_sideways_max(), ours->vel_sideways_max(),
                    specs.max_speed_sideways);
    reader.positive("acc_speedup_sideways_max", ours->has_acc_speedup_sideways_max(),
                    ours->acc_speedup_sideways_max(), specs.max_acceleration_sideways);
    reader.positive("acc_brake_sideways_max", ours->has_acc_brake_sideways_max(),
                    ours->acc_brake_sideways_max(), specs.max_brake_sideways);
  } else if (const auto theirs = unpacked<proto::RobotSpecErForce>(custom, {"", "sslsim."})) {
    reader.positive("dribbler_width", theirs->has_dribbler_width(), theirs->dribbler_width(),
                    specs.dribbler_width);
    if (theirs->has_shoot_radius()) {
      reader.unsupported("shoot_radius is ignored: where the ball lies follows from center_to_dribbler");
    }
  } else {
    reader.unsupported(
        fmt::format("custom \"{}\" is not known or not readable; known are "
                    "matchday.simulation.RobotSpecsMatchday and sslsim.RobotSpecErForce",
                    printable(custom.type_url())));
  }
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
  limits.set_acc_brake_angular_max(static_cast<float>(specs.max_angular_brake));
  limits.set_vel_absolute_max(static_cast<float>(specs.max_speed));
  limits.set_vel_angular_max(static_cast<float>(specs.max_angular_speed));
  proto::RobotSpecsMatchday ours;
  ours.set_dribbler_width(static_cast<float>(specs.dribbler_width));
  ours.set_vel_sideways_max(static_cast<float>(specs.max_speed_sideways));
  ours.set_acc_speedup_sideways_max(static_cast<float>(specs.max_acceleration_sideways));
  ours.set_acc_brake_sideways_max(static_cast<float>(specs.max_brake_sideways));
  out.add_custom()->PackFrom(ours);
}

std::optional<world::RobotId> decode(const proto::RobotId& id) {
  const bool known = id.has_id() && id.id() <= world::max_robot_number &&
                     (id.team() == matchday::simulation::YELLOW || id.team() == matchday::simulation::BLUE);
  if (!known) return std::nullopt;
  return world::RobotId{id.team() == matchday::simulation::YELLOW ? world::Team::Yellow : world::Team::Blue,
                        static_cast<std::uint8_t>(id.id())};
}

Problem not_a_robot(std::string_view owner, const proto::RobotId& id) {
  const std::string number = id.has_id() ? fmt::format("number {}", id.id()) : "no number";
  const std::string team = id.has_team() ? "team " + proto::Team_Name(id.team()) : "no team";
  return {code::robot_id,
          fmt::format("{}: the id has {} and {}; it must have a team, YELLOW or BLUE, and a number, 0 to {}",
                      owner, team, number, world::max_robot_number)};
}

std::vector<Problem> apply(const proto::RobotSpecs& message, world::RobotSpecs& specs, WheelAngles& wheels) {
  std::vector<Problem> problems;
  Reader reader(problems);
  reader.positive("radius", message.has_radius(), message.radius(), specs.radius);
  reader.positive("height", message.has_height(), message.height(), specs.height);
  reader.positive("mass", message.has_mass(), message.mass(), specs.mass);
  reader.positive("max_linear_kick_speed", message.has_max_linear_kick_speed(),
                  message.max_linear_kick_speed(), specs.max_kick_speed);
  reader.positive("max_chip_kick_speed", message.has_max_chip_kick_speed(), message.max_chip_kick_speed(),
                  specs.max_chip_speed);
  reader.positive("center_to_dribbler", message.has_center_to_dribbler(), message.center_to_dribbler(),
                  specs.center_to_dribbler);
  if (message.has_limits()) apply_limits(message.limits(), specs, reader);
  if (message.has_wheel_angles()) apply_wheels(message.wheel_angles(), wheels, reader);
  for (const google::protobuf::Any& custom : message.custom()) apply_custom(custom, specs, reader);
  return problems;
}

std::optional<world::RobotSpecs> decode(const proto::RobotSpecs& specs) {
  const std::optional<world::RobotId> id = decode(specs.id());
  if (!id) return std::nullopt;
  world::RobotSpecs result;
  result.id = *id;
  WheelAngles not_asked_for;
  apply(specs, result, not_asked_for);
  return result;
}

}  // namespace wire
