#pragma once

#include <memory>
#include <optional>
#include <string>

#include "sim/truth/truth.h"
#include "sim/world/referee_message.h"
#include "sim/world/robot_command.h"

namespace host {

/// The fingerprint of a game: two games with the same one went the same way, tick by tick.
///
/// XXH3-128 over the bits of the true poses and velocities, the commands applied, and what the referee said.
/// No text, no paths, no wall time. Two builds give the same only if they are the same binary on CPUs of the
/// same feature class.
class GameHash {
 public:
  GameHash();
  ~GameHash();
  GameHash(const GameHash&) = delete;
  GameHash& operator=(const GameHash&) = delete;

  /// One tick.
  void add(const truth::Frame& truth, const world::PerTeam<world::TeamCommands>& commands,
           const world::RefereeMessage& message, const std::optional<world::Vector2d>& ball_reset);

  /// 32 hexadecimal digits.
  std::string digits() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace host
