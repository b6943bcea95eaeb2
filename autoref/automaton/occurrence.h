#pragma once

#include <cstdint>
#include <optional>

#include "sim/world/game_event.h"

namespace automaton {

/// How the laws punish a foul: an indirect or a direct free kick (a penalty in the offender's own area).
enum class Severity : std::uint8_t { Minor, Serious };

/// What a robot's team is shown for an offence.
enum class Card : std::uint8_t { None, Yellow, Red };

struct Foul {
  world::RobotId by;
  world::Vector2d location = world::Vector2d::Zero();  ///< [m] where the free kick is due
  Severity severity = Severity::Minor;
  Card card = Card::None;
};

/// A team asks for something; the paper does not say how (I-42), here it comes from outside the referee.
struct Request {
  enum class Kind : std::uint8_t { BeginTimeout, EndTimeout };
  Kind kind{};
  world::Team team{};
};

/// Something that happened in this tick and that one row may take: an event, or a request.
struct Occurrence {
  std::optional<world::GameEvent> event;
  std::optional<Foul> foul;  ///< when the event is one
  std::optional<Request> request;
};

/// The foul an event is, by the laws of 2015, Law 12; nothing for events that are none.
std::optional<Foul> foul_of(const world::GameEvent& event);

Occurrence occurrence_of(const world::GameEvent& event);

}  // namespace automaton
