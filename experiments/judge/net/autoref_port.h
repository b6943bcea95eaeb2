#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/proto/autoref.pb.h"

namespace judge {

/// The game controller's port for autorefs: greets, registers, and hears what they report. It never blocks.
///
/// Source  the league's protocol (reference "protocol", 2.8): TCP, varint lengths;
///         a reply first, one registration, then one reply to every message. Signatures are not looked at,
///         as for a name without a key.
class AutorefPort {
 public:
  static constexpr std::uint16_t number = 10007;

  /// Listens on every interface.
  /// @throws std::system_error
  AutorefPort();
  ~AutorefPort();
  AutorefPort(const AutorefPort&) = delete;
  AutorefPort& operator=(const AutorefPort&) = delete;

  /// Answers what came since, and appends the events in it.
  void listen(std::vector<matchday::referee::GameEvent>& events);
  /// Names of those that have ever registered.
  const std::vector<std::string>& registered() const { return registered_; }

 private:
  struct Client;
  bool hear(Client& client, std::vector<matchday::referee::GameEvent>& events);

  int socket_ = -1;
  std::vector<std::unique_ptr<Client>> clients_;
  std::vector<std::string> registered_;
};

}  // namespace judge
