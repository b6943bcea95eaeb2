#include "experiments/host/peer.h"

#include <sys/socket.h>

#include "experiments/process/family.h"

namespace host {

Whose whose(pid_t peer, const Family& own, const Family& opponents) {
  if (peer <= 0) return Whose::Strangers;
  if (process::belongs_to(peer, own.process)) return Whose::Own;
  if (process::belongs_to(peer, opponents.process)) return Whose::Opponents;
  return process::was_started_with(peer, own.mark) ? Whose::OwnBySaying : Whose::Strangers;
}

pid_t peer_of(int socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return ::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 ? peer.pid : 0;
}

}  // namespace host
