#include "sim/world/game_state.h"

namespace world {

const char* name(Location location) {
  switch (location) {
    case Location::Init:
      return "INIT";
    case Location::GameOn:
      return "GAME_ON";
    case Location::GameOff:
      return "GAME_OFF";
    case Location::Setup:
      return "SETUP";
    case Location::Break:
      return "BREAK";
  }
  return "?";
}

const char* name(Stage stage) {
  switch (stage) {
    case Stage::PreFirst:
      return "PRE-FIRST";
    case Stage::First:
      return "FIRST";
    case Stage::HalfTime:
      return "HALFTIME";
    case Stage::PreSecond:
      return "PRE-SECOND";
    case Stage::Second:
      return "SECOND";
    case Stage::ExtraBreak:
      return "EXTRA-BREAK";
    case Stage::PreExtraFirst:
      return "PRE-EXTRA-FIRST";
    case Stage::ExtraFirst:
      return "EXTRA-FIRST";
    case Stage::ExtraHalfTime:
      return "EXTRA-HALFTIME";
    case Stage::PreExtraSecond:
      return "PRE-EXTRA-SECOND";
    case Stage::ExtraSecond:
      return "EXTRA-SECOND";
    case Stage::ShootoutBreak:
      return "SHOOTOUT-BREAK";
    case Stage::Shootout:
      return "SHOOTOUT";
    case Stage::Post:
      return "POST";
  }
  return "?";
}

const char* name(CommandKind kind) {
  switch (kind) {
    case CommandKind::Halt:
      return "HALT";
    case CommandKind::Stop:
      return "STOP";
    case CommandKind::Indirect:
      return "INDIRECT";
    case CommandKind::Direct:
      return "DIRECT";
    case CommandKind::Kickoff:
      return "KICKOFF";
    case CommandKind::Penalty:
      return "PENALTY";
    case CommandKind::Goal:
      return "GOAL";
    case CommandKind::Ready:
      return "READY";
    case CommandKind::Start:
      return "START";
    case CommandKind::Timeout:
      return "TIMEOUT";
  }
  return "?";
}

}  // namespace world
