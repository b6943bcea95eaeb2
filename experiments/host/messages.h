#pragma once

#include <google/protobuf/arena.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "experiments/record/match_config.h"
#include "sim/engine/engine.h"
#include "sim/wire/match.h"
#include "sim/world/referee_message.h"

namespace host {

/// Where a team may write: a folder of its own in the game's; empty when the game has none.
std::filesystem::path log_folder(world::Team team, const record::MatchConfig& config);

/// The hello to one team.
std::string hello_frame(world::Team team, const record::MatchConfig& config, const engine::Model& model);

/// The messages of one tick, in memory that is used again.
///
/// All but the feedback is the same for both teams and is serialised once. The referee message is encoded
/// anew when it changes and ten times a second, the rate of the league's game controller; between, the last
/// one is sent again.
class TickMessages {
 public:
  TickMessages();

  /// Encodes what both teams get.
  void encode(const engine::Engine& engine, const world::RefereeMessage& referee, bool referee_changed);

  /// The frame for one team, valid until the next call for it.
  const std::string& frame(world::Team team, const engine::Engine& engine);

  /// An answer to a request that cannot be granted, for the next frame of the team.
  void refuse(world::Team team, std::string_view code, std::string_view why);

  const google::protobuf::RepeatedPtrField<wire::proto::SSL_WrapperPacket>& packets() const {
    return tick_.packets();
  }
  /// Null when it was not encoded anew.
  const wire::proto::Referee* fresh_referee() const { return referee_is_fresh_ ? &tick_.referee() : nullptr; }

 private:
  wire::proto::MatchTick tick_;
  std::string shared_;
  bool referee_is_fresh_ = false;
  std::int64_t referee_tick_ = -1;  // when it was encoded last
  world::PerTeam<std::string> frames_;
  world::PerTeam<wire::proto::RobotControlResponse> responses_;
  std::vector<wire::Feedback> feedback_;
};

/// Reads what a team sent, in memory that is used again: nothing is allocated after the first message.
class MessageParser {
 public:
  /// The message, valid until the next call; null when the bytes are none.
  const wire::proto::TeamMessage* parse(std::span<const std::byte> payload);

 private:
  std::vector<char> memory_ = std::vector<char>(16384);
  google::protobuf::Arena arena_{memory_.data(), memory_.size()};
};

}  // namespace host
