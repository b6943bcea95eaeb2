#include "sim/wire/robot_control.h"

#include <fmt/format.h>

#include <bitset>
#include <utility>

#include "sim/wire/units.h"

namespace wire {

namespace {

// Beyond these a value is nonsense, not a wish. Ours: ten times and more what any robot of the league can do;
// what the robot at hand can do is the simulator's business.
constexpr float max_speed = 100;            // [m/s]
constexpr float max_angular_speed = 1000;   // [rad/s]
constexpr float max_kick_angle = 90;        // [degrees]
constexpr float max_dribbler_speed = 1e6F;  // [rpm]

/// The first of a message's values that cannot be meant.
class Checks {
 public:
  explicit Checks(std::uint32_t robot) : robot_(robot) {}
  void within(const char* name, float value, float lowest, float highest) {
    if (problem_ || (value >= lowest && value <= highest)) return;  // not so for NaN
    problem_ = Problem{code::value, fmt::format("robot {}: {} = {} must be from {} to {}", robot_, name,
                                                value, lowest, highest)};
  }
  void speed(const char* name, float value) { within(name, value, -max_speed, max_speed); }
  void turn(const char* name, float value) { within(name, value, -max_angular_speed, max_angular_speed); }
  std::optional<Problem>& problem() { return problem_; }

 private:
  std::uint32_t robot_;
  std::optional<Problem> problem_;
};

void decode_move(const proto::RobotMoveCommand& move, RobotOrder& out, Checks& checks) {
  switch (move.command_case()) {
    case proto::RobotMoveCommand::kLocalVelocity: {
      const proto::MoveLocalVelocity& velocity = move.local_velocity();
      checks.speed("forward", velocity.forward());
      checks.speed("left", velocity.left());
      checks.turn("angular", velocity.angular());
      out.command.velocity_local = {velocity.forward(), velocity.left()};
      out.command.angular_velocity = velocity.angular();
      break;
    }
    case proto::RobotMoveCommand::kGlobalVelocity: {
      const proto::MoveGlobalVelocity& velocity = move.global_velocity();
      checks.speed("x", velocity.x());
      checks.speed("y", velocity.y());
      checks.turn("angular", velocity.angular());
      out.move = GlobalVelocity{{velocity.x(), velocity.y()}, velocity.angular()};
      break;
    }
    case proto::RobotMoveCommand::kWheelVelocity: {
      const proto::MoveWheelVelocity& wheels = move.wheel_velocity();
      checks.speed("front_right", wheels.front_right());
      checks.speed("back_right", wheels.back_right());
      checks.speed("back_left", wheels.back_left());
      checks.speed("front_left", wheels.front_left());
      out.move =
          WheelSpeeds{wheels.front_right(), wheels.back_right(), wheels.back_left(), wheels.front_left()};
      break;
    }
    case proto::RobotMoveCommand::COMMAND_NOT_SET:
      break;
  }
}

}  // namespace

Result<RobotOrder> decode_order(const proto::RobotCommand& command) {
  if (!command.has_id()) return Problem{code::robot_id, "a robot command has no id"};
  if (command.id() > world::max_robot_number) {
    return Problem{code::robot_id, fmt::format("robot {}: numbers go from 0 to 15", command.id())};
  }
  RobotOrder order;
  order.command.number = static_cast<std::uint8_t>(command.id());
  Checks checks(command.id());
  decode_move(command.move_command(), order, checks);
  checks.within("kick_speed", command.kick_speed(), 0, max_speed);
  checks.within("kick_angle", command.kick_angle(), 0, max_kick_angle);
  checks.within("dribbler_speed", command.dribbler_speed(), -max_dribbler_speed, max_dribbler_speed);
  if (checks.problem()) return std::move(*checks.problem());
  order.command.kick_speed = command.kick_speed();
  order.command.kick_angle = from_degrees(command.kick_angle());
  order.command.dribbler_speed = from_rpm(command.dribbler_speed());
  return order;
}

void encode(const world::TeamCommands& commands, proto::RobotControl& out) {
  // Not cleared: that would free each velocity, the member of a oneof, to make it anew below.
  auto& entries = *out.mutable_robot_commands();
  while (entries.size() > static_cast<int>(commands.size())) entries.RemoveLast();
  int count = 0;
  for (const world::RobotCommand& command : commands) {
    proto::RobotCommand& entry = count < entries.size() ? *entries.Mutable(count) : *entries.Add();
    ++count;
    entry.clear_kick_speed();
    entry.clear_kick_angle();
    entry.clear_dribbler_speed();
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
    const Result<RobotOrder> result = decode_order(command);
    const RobotOrder* order = std::get_if<RobotOrder>(&result);
    if (!order || !std::holds_alternative<std::monostate>(order->move) || seen[order->command.number]) {
      ++bad_commands;
      continue;
    }
    seen.set(order->command.number);
    out.push_back(order->command);
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
