#pragma once

#include <string>
#include <string_view>

#include "sim/proto/match.pb.h"
#include "sim/wire/referee.h"
#include "sim/wire/robot_control.h"
#include "sim/wire/vision.h"

namespace wire {

namespace proto {
using namespace matchday::match;  // NOLINT: that is the purpose
}

inline constexpr std::uint32_t match_protocol_version = 1;

/// Appends a HostMessage with this tick as one frame, without copying the part that both teams share.
///
/// The bytes are those of `append_frame` for the same tick with `feedback` set: feedback has the highest
/// field number and so comes last.
///
/// @param shared  a serialised MatchTick without feedback
/// @throws FrameError when it is longer than 1 MiB
void append_tick_frame(std::string& out, std::string_view shared,
                       const proto::RobotControlResponse& feedback);

}  // namespace wire
