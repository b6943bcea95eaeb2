#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "teams/kit/team.h"

namespace kit {

/// Makes a team once the host has said what it is to play with.
///
/// @param notes  whether anyone wants `Team::note`
using MakeTeam = std::function<std::unique_ptr<Team>(const Setup&, bool notes)>;

/// One game as the team sees it: host messages in, answers out. No sockets: payloads and bytes.
///
/// Decoding, tracking and encoding reuse their memory; a tick allocates nothing in the steady state.
class Session {
 public:
  struct Options {
    std::string name = "team";
    std::string version = "0.1.0";
    std::optional<int> keeper;  ///< instead of the team's own choice
    bool notes = false;         ///< send the team's notes for the game's log
  };
  Session(Options options, MakeTeam make_team);
  ~Session();

  /// Takes the payload of one HostMessage.
  ///
  /// @return  the answer, framed, to be sent as it is and valid until the next call; empty after goodbye
  /// @throws  std::runtime_error when it is no HostMessage, or comes out of turn, or speaks another version
  std::string_view answer(std::span<const std::byte> payload);

  bool greeted() const { return team_ != nullptr; }  ///< the hello was answered; what follows are ticks
  bool over() const { return over_; }
  const std::string& goodbye_reason() const { return reason_; }
  /// What the team says about its game; empty before a hello.
  std::string summary() const { return team_ ? team_->summary() : std::string{}; }

 private:
  struct Messages;  // protobuf objects and buffers, used again every tick

  void hello();
  void tick(std::span<const std::byte> match_tick);

  Options options_;
  MakeTeam make_team_;
  std::unique_ptr<Messages> messages_;
  std::unique_ptr<Team> team_;
  bool over_ = false;
  std::string reason_;
};

}  // namespace kit
