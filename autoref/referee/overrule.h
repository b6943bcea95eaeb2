#pragma once

#include <optional>
#include <string>

#include "autoref/automaton/automaton.h"
#include "autoref/referee/override.h"

namespace referee {

/// A decision that stopped play, with what is needed to take it back.
struct Decision {
  std::string sentence;
  world::GameState before;
  world::GameState after;
  world::Vector2d ball = world::Vector2d::Zero();  ///< [m] when it was made
};

/// What an override may look at and change.
struct Overruled {
  automaton::Automaton& automaton;
  const world::TrackedFrame& frame;   ///< the last one
  world::Vector2d ball;               ///< [m] now
  std::optional<Decision>& decision;  ///< the last one that can still be reversed; nothing: see `restarted`
  bool any_decision = false;          ///< there has been one in this game
};

/// What came of an override.
struct Verdict {
  std::string refusal;  ///< one sentence; empty when it was done
  std::string deed;     ///< what was done, to follow the operator's name: "pauses the game"
};

/// Does what the operator wants, or changes nothing and says why not.
Verdict overrule(const Override& wish, Overruled& game);

}  // namespace referee
