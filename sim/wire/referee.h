#pragma once

#include <optional>

#include "sim/proto/referee.pb.h"
#include "sim/wire/epoch.h"
#include "sim/world/game_event.h"
#include "sim/world/referee_message.h"

namespace wire {

namespace proto {
using namespace matchday::referee;  // NOLINT: that is the purpose
}

/// The referee's message in the league's current schema. Reuses the memory of `out`; leaves out game events.
///
/// READY is NORMAL_START, START is FORCE_START, KICKOFF and PENALTY are PREPARE_KICKOFF and PREPARE_PENALTY.
void encode(const world::RefereeMessage& message, Epoch epoch, proto::Referee& out);

/// The referee's message from the wire, of any version since 2013; nothing when stage or
/// command are missing or unknown. Numbers and texts beyond all meaning are cut to what has one;
/// a keeper above 255 is 255: nobody.
///
/// BALL_PLACEMENT, which the paper does not have, reads as STOP with its designated position.
std::optional<world::RefereeMessage> decode(const proto::Referee& message, Epoch epoch);
/// The same into memory that is used again; false, and `out` unchanged, where the other returns nothing.
bool decode(const proto::Referee& message, Epoch epoch, world::RefereeMessage& out);

/// The league's event for one of ours; false, and `out` empty, when the league has none.
bool encode(const world::GameEvent& event, Epoch epoch, proto::GameEvent& out);

}  // namespace wire
