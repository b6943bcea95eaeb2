#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/proto/simulation.pb.h"
#include "sim/wire/problem.h"
#include "sim/world/robot_command.h"
#include "sim/world/robot_specs.h"

namespace wire {

namespace proto {
using namespace matchday::simulation;  // NOLINT: that is the purpose
}

/// A wish for a velocity in the field frame.
struct GlobalVelocity {
  world::Vector2d velocity = world::Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;                         ///< [rad/s]
};

/// Speeds of the wheels' rims [m/s]; positive drives the robot round counter-clockwise, seen from above.
struct WheelSpeeds {
  double front_right = 0;
  double back_right = 0;
  double back_left = 0;
  double front_left = 0;
};

/// A command as it is on the wire: it may move in ways that need a pose or wheel angles to be understood.
struct RobotOrder {
  world::RobotCommand command;  ///< its velocities are zero when `move` says how to move
  std::variant<std::monostate, GlobalVelocity, WheelSpeeds> move;
};

/// One command from the wire; all three ways to move. No move command at all means standing still, a missing
/// speed in one is 0.
///
/// A problem is a number that is missing or above 15, and a value that is not finite or absurd (see the
/// limits in the source).
Result<RobotOrder> decode_order(const proto::RobotCommand& command);

/// Commands for the robots of one team: local velocity, degrees, rpm.
void encode(const world::TeamCommands& commands, proto::RobotControl& out);

/// Commands from the wire, in their order.
///
/// A command is bad, and left out, when `decode_order` has a problem with it, when its robot was there
/// before, or when it moves by wheels or in the field frame, which needs a pose that the wire does not have.
///
/// @param bad_commands  how many were left out is added to it
void decode(const proto::RobotControl& control, world::TeamCommands& out, int& bad_commands);
world::TeamCommands decode(const proto::RobotControl& control, int& bad_commands);
world::TeamCommands decode(const proto::RobotControl& control);

/// Where the wheels are [rad]: clockwise from forward, seen from above, as the league counts them.
struct WheelAngles {
  double front_right = 0.25 * std::numbers::pi;
  double back_right = 0.75 * std::numbers::pi;
  double back_left = 1.25 * std::numbers::pi;
  double front_left = 1.75 * std::numbers::pi;
};

/// The robot that is meant; nothing when team or number are missing or unknown.
std::optional<world::RobotId> decode(const proto::RobotId& id);
/// What to say of an id that means no robot (code::robot_id).
/// @param owner  what it stands in, as "teleport_robot"
Problem not_a_robot(std::string_view owner, const proto::RobotId& id);

/// The league's specs, and what it has no fields for as a RobotSpecsMatchday in `custom`; no wheel angles.
void encode(const world::RobotSpecs& specs, proto::RobotSpecs& out);
/// Specs from the wire; what the message does not say, or says badly, keeps its default. Limits for moving
/// sideways that it does not say are the forward ones.
/// @returns nothing when team or number are missing or unknown
std::optional<world::RobotSpecs> decode(const proto::RobotSpecs& specs);
/// Changes what the message says, except the id; the rest, and what it says badly, stays as it is.
///
/// A limit of the league's for moving counts forward and sideways; RobotSpecsMatchday may then say otherwise.
/// ER-Force's RobotSpecErForce is understood for its dribbler_width.
///
/// @returns  one problem for each bad field (code::spec) and each that nothing here can
///           follow (code::unsupported)
std::vector<Problem> apply(const proto::RobotSpecs& message, world::RobotSpecs& specs, WheelAngles& wheels);

/// What one robot tells its team.
struct Feedback {
  std::uint8_t number = 0;
  bool ball_contact = false;  ///< the break beam: ball at the dribbler
  bool operator==(const Feedback&) const = default;
};

/// Replaces the feedback in `out`; errors in it stay.
void encode(std::span<const Feedback> feedback, proto::RobotControlResponse& out);
/// Feedback of known robots (numbers 0 to 15).
std::vector<Feedback> decode(const proto::RobotControlResponse& response);
/// Adds an error, e.g. a refused request.
void add_error(std::string_view code, std::string_view message, proto::RobotControlResponse& out);

}  // namespace wire
