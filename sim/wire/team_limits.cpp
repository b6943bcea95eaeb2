#include "sim/wire/team_limits.h"

#include <algorithm>

#include "sim/console/printable.h"

namespace wire {
namespace {

std::string too_many(std::size_t size, const std::string& what, std::size_t limit) {
  return std::to_string(size) + what + ", " + std::to_string(limit) + " are allowed";
}

std::string excess(const std::string& text, const std::string& what) {
  if (text.size() > max_team_text) {
    return "gives a " + what + " of " + too_many(text.size(), " bytes", max_team_text);
  }
  if (!console::is_visible(text)) {
    return "gives a " + what +
           " with characters that control something or are not seen, or of bytes that are "
           "no UTF-8";
  }
  return "";
}

bool has_unknown_fields(const proto::RobotCommand& command) {
  const proto::RobotMoveCommand& move = command.move_command();
  return !command.unknown_fields().empty() || !move.unknown_fields().empty() ||
         !move.local_velocity().unknown_fields().empty() ||
         !move.global_velocity().unknown_fields().empty() || !move.wheel_velocity().unknown_fields().empty();
}

bool has_unknown_fields(const proto::MatchReply& reply) {
  const auto& commands = reply.control().robot_commands();
  return !reply.control().unknown_fields().empty() || !reply.request().unknown_fields().empty() ||
         std::any_of(commands.begin(), commands.end(),
                     [](const proto::RobotCommand& command) { return has_unknown_fields(command); });
}

}  // namespace

std::string excess(const proto::MatchReply& reply) {
  const int commands = reply.control().robot_commands_size();
  if (commands > max_robot_commands) {
    return "sent " + too_many(static_cast<std::size_t>(commands), " robot commands in one reply",
                              static_cast<std::size_t>(max_robot_commands));
  }
  if (reply.note().size() > max_note) {
    return "sent a note of " + too_many(reply.note().size(), " bytes", max_note);
  }
  return "";
}

std::string excess(const proto::TeamHello& hello) {
  const std::string name = excess(hello.name(), "name");
  return name.empty() ? excess(hello.version(), "version") : name;
}

void copy_what_counts(const proto::MatchReply& reply, proto::MatchReply& out) {
  out.set_tick(reply.tick());
  if (reply.has_control()) out.mutable_control()->CopyFrom(reply.control());
  if (reply.has_request()) out.mutable_request()->CopyFrom(reply.request());
  if (has_unknown_fields(reply)) out.DiscardUnknownFields();  // by reflection: only when it must be
}

}  // namespace wire
