#pragma once

#include <cstddef>
#include <string>

#include "sim/wire/match.h"
#include "sim/world/robot_id.h"

// How much a team may send, by what it means. More is its fault; nothing of it is kept.
namespace wire {

// Ours. A command for each robot number takes at most 45 bytes, all of them 720; with the longest note and a
// request that is a reply of 1.8 KiB. Twice that, for fields of tomorrow.
inline constexpr std::size_t max_team_frame = 4096;                     ///< [bytes]
inline constexpr int max_robot_commands = world::max_robot_number + 1;  ///< in one reply
inline constexpr std::size_t max_note = 1024;                           ///< [bytes]; ours take 300
inline constexpr std::size_t max_team_text = 100;  ///< [bytes] of a name or a version, as in a table's column

/// What of it is too much or cannot be shown, with number and limit: "sent 17 robot commands in one reply, 16
/// are allowed"; empty when nothing is.
std::string excess(const proto::MatchReply& reply);
std::string excess(const proto::TeamHello& hello);

/// The parts on which a game depends: neither the note nor fields that are not in match.proto.
void copy_what_counts(const proto::MatchReply& reply, proto::MatchReply& out);

}  // namespace wire
