#pragma once

#include <optional>
#include <string>

#include "sim/world/game_event.h"
#include "sim/world/game_state.h"

namespace referee {

/// One decision of the referee that anyone on the field notices: it sent a command, stopped play, or showed a
/// card. Offences that the laws leave without consequence are calls too, of row "note".
struct Call {
  world::Time time;                         ///< of the frame it was made on
  std::string row;                          ///< of the paper's transition tables, such as "T11.7"
  std::optional<world::GameEvent> event;    ///< what was seen; nothing when only time ran out
  std::optional<world::Command> command;    ///< sent to the teams
  std::string restart;                      ///< how play goes on: "indirect free kick for blue"; may be empty
  std::optional<world::Vector2d> position;  ///< [m] from where; nothing when `restart` is empty
  std::string sentence;                     ///< why, for a player
  bool stops_play = false;                  ///< the ball was in play, or a kick was due, until this call
  std::optional<world::RobotId> offender;   ///< who broke a rule, if anyone did
  world::Stage stage = world::Stage::PreFirst;  ///< after the call
  world::PerTeam<int> score{};                  ///< after the call
  std::string evidence;  ///< the long record (evidence.h), one line of JSON; empty unless Setup::explain
};

/// One line without line break: match time as m:ss.mmm, row, command, score, sentence.
std::string format_call(const Call& call);

}  // namespace referee
