#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/proto/simulation.pb.h"
#include "sim/world/robot_command.h"
#include "sim/world/robot_specs.h"

namespace wire {

namespace proto {
using namespace matchday::simulation;  // NOLINT: that is the purpose
}

/// Commands for the robots of one team: local velocity, degrees, rpm.
void encode(const world::TeamCommands& commands, proto::RobotControl& out);

/// Commands from the wire, in their order.
///
/// A command is bad, and left out, when its robot number is missing, above 15 or was there before, when a
/// value is not finite or absurd (see the limits in the source), or when it moves by wheels or in the field
/// frame, which needs a pose that the wire does not have. No move command at all means standing still.
///
/// @param bad_commands  how many were left out is added to it
void decode(const proto::RobotControl& control, world::TeamCommands& out, int& bad_commands);
world::TeamCommands decode(const proto::RobotControl& control, int& bad_commands);
world::TeamCommands decode(const proto::RobotControl& control);

/// The league's specs; absent are wheel angles and our dribbler width.
void encode(const world::RobotSpecs& specs, proto::RobotSpecs& out);
/// Specs from the wire; what the message does not say, or says badly, keeps its default.
/// @returns nothing when team or number are missing or unknown
std::optional<world::RobotSpecs> decode(const proto::RobotSpecs& specs);

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
