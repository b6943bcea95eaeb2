#pragma once

#include <optional>

#include "experiments/judge/shadow.h"
#include "sim/proto/game_event.pb.h"

namespace judge {

/// Whether the league has an event for it, so that an outside autoref can say it.
bool can_be_reported(Event event);

/// What an outside autoref reports, as a call.
///
/// It happened when the report says it was created, if that is a time of this match in the 10 s before `now`;
/// else now: programs that go by their own clock say nothing else.
/// @return  nothing for events that are no calls here
std::optional<Call> call_of(const matchday::referee::GameEvent& reported, world::Time now);

}  // namespace judge
