#include "autoref/automaton/occurrence.h"

namespace automaton {

std::optional<Foul> foul_of(const world::GameEvent& event) {
  if (const auto* kick = std::get_if<world::BotKickedBallTooFast>(&event.what)) {
    return Foul{kick->by, kick->location, Severity::Minor, Card::None};
  }
  if (const auto* dribble = std::get_if<world::BotDribbledBallTooFar>(&event.what)) {
    return Foul{dribble->by, dribble->end, Severity::Minor, Card::None};
  }
  return std::nullopt;
}

Occurrence occurrence_of(const world::GameEvent& event) { return {event, foul_of(event), std::nullopt}; }

}  // namespace automaton
