#include "sim/wire/robot_control.h"

#include <bitset>
#include <cmath>

#include "sim/wire/units.h"

namespace wire {

namespace {

// Beyond these a value is nonsense, not a wish. Ours: ten times and more what any robot of the league can do;
// what the robot at hand can do is the simulator's business.
constexpr float max_speed = 100;            // [m/s]
constexpr float max_angular_speed = 1000;   // [rad/s]
constexpr float max_kick_angle = 90;        // [degrees]
constexpr float max_dribbler_speed = 1e6F;  // [rpm]

bool is_within(float value, float limit) { return std::abs(value) <= limit; }  // false for NaN

std::optional<world::RobotCommand> decode_command(const proto::RobotCommand& command) {
  if (!command.has_id() || command.id() > world::max_robot_number) return std::nullopt;
  world::RobotCommand result;
  result.number = static_cast<std::uint8_t>(command.id());

  switch (command.move_command().command_case()) {
    case proto::RobotMoveCommand::kLocalVelocity: {
      const proto::MoveLocalVelocity& velocity = command.move_command().local_velocity();
      if (!is_within(velocity.forward(), max_speed) || !is_within(velocity.left(), max_speed) ||
          !is_within(velocity.angular(), max_angular_speed)) {
        return std::nullopt;
      }
      result.velocity_local = {velocity.forward(), velocity.left()};
      result.angular_velocity = velocity.angular();
      break;
    }
    case proto::RobotMoveCommand::COMMAND_NOT_SET:
      break;
    case proto::RobotMoveCommand::kWheelVelocity:
    case proto::RobotMoveCommand::kGlobalVelocity:
      return std::nullopt;
  }

  const bool kick_makes_sense = command.kick_speed() >= 0 && is_within(command.kick_speed(), max_speed) &&
                                command.kick_angle() >= 0 && is_within(command.kick_angle(), max_kick_angle);
  if (!kick_makes_sense || !is_within(command.dribbler_speed(), max_dribbler_speed)) return std::nullopt;
  result.kick_speed = command.kick_speed();
  result.kick_angle = from_degrees(command.kick_angle());
  result.dribbler_speed = from_rpm(command.dribbler_speed());
  return result;
}

}  // namespace

void encode(const world::TeamCommands& commands, proto::RobotControl& out) {
  out.Clear();
  for (const world::RobotCommand& command : commands) {
    proto::RobotCommand& entry = *out.add_robot_commands();
    entry.set_id(command.number);
    proto::MoveLocalVelocity& velocity = *entry.mutable_move_command()->mutable_local_velocity();
    velocity.set_forward(static_cast<float>(command.velocity_local.x()));
    velocity.set_left(static_cast<float>(command.velocity_local.y()));
    velocity.set_angular(static_cast<float>(command.angular_velocity));
    if (command.kick_speed != 0) entry.set_kick_speed(static_cast<float>(command.kick_speed));
    if (command.kick_angle != 0) entry.set_kick_angle(static_cast<float>(to_degrees(command.kick_angle)));
    if (command.dribbler_speed != 0) {
      entry.set_dribbler_speed(static_cast<float>(to_rpm(command.dribbler_speed)));
    }
  }
}

void decode(const proto::RobotControl& control, world::TeamCommands& out, int& bad_commands) {
  out.clear();
  std::bitset<world::max_robot_number + 1> seen;
  for (const proto::RobotCommand& command : control.robot_commands()) {
    const std::optional<world::RobotCommand> result = decode_command(command);
    if (!result || seen[result->number]) {
      ++bad_commands;
      continue;
    }
    seen.set(result->number);
    out.push_back(*result);
  }
}

world::TeamCommands decode(const proto::RobotControl& control, int& bad_commands) {
  world::TeamCommands result;
  decode(control, result, bad_commands);
  return result;
}

world::TeamCommands decode(const proto::RobotControl& control) {
  int ignored = 0;
  return decode(control, ignored);
}

void encode(std::span<const Feedback> feedback, proto::RobotControlResponse& out) {
  out.clear_feedback();
  for (const Feedback& robot : feedback) {
    proto::RobotFeedback& entry = *out.add_feedback();
    entry.set_id(robot.number);
    entry.set_dribbler_ball_contact(robot.ball_contact);
  }
}

std::vector<Feedback> decode(const proto::RobotControlResponse& response) {
  std::vector<Feedback> result;
  for (const proto::RobotFeedback& robot : response.feedback()) {
    if (!robot.has_id() || robot.id() > world::max_robot_number) continue;
    result.push_back({static_cast<std::uint8_t>(robot.id()), robot.dribbler_ball_contact()});
  }
  return result;
}

void add_error(std::string_view code, std::string_view message, proto::RobotControlResponse& out) {
  proto::SimulatorError& error = *out.add_errors();
  error.set_code(std::string(code));
  error.set_message(std::string(message));
}

}  // namespace wire
