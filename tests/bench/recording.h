#pragma once

#include <string>
#include <vector>

#include "tests/bench/game.h"

namespace hot {

/// What every part of one tick was given, and what it gave.
struct Tick {
  world::PerTeam<world::TeamCommands> commands;  ///< that drove the step
  truth::Frame truth;
  std::vector<world::Detection> detections;
  world::TrackedFrame frame;  ///< the referee's, with touches
  world::RefereeMessage message;
  bool message_changed = false;
  world::PerTeam<std::string> payloads;  ///< to the teams, without their length
  world::PerTeam<std::string> replies;   ///< from them, framed
};

/// A game, tick by tick, from its first one.
struct Recording {
  record::MatchConfig config;
  referee::Setup setup;
  world::PerTeam<std::string> hellos;  ///< framed
  std::vector<Tick> ticks;
};

/// Plays the game so long [s] and keeps it.
Recording recorded(const kit::MakeTeam& players, double seconds);

}  // namespace hot
