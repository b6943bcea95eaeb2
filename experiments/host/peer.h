#pragma once

#include <sys/types.h>

#include <string>

namespace host {

/// The processes of one team: the one that was started, and a line of the environment it was given.
struct Family {
  pid_t process = -1;  ///< -1: none
  std::string mark;    ///< "NAME=VALUE"
};

/// Whose process is at the other end of a connection.
enum class Whose {
  Own,          ///< of the team the socket is for
  OwnBySaying,  ///< it has left its parents, group and session, but has the team's environment
  Opponents,
  Strangers
};

/// Whose a process is.
///
/// Parents, process group and session cannot be claimed by others. The environment can, by whoever reads it
/// in /proc: good enough to be let in, not to be blamed for.
///
/// @param peer  its number in our process view; 0 when it is outside
Whose whose(pid_t peer, const Family& own, const Family& opponents);

/// The process that connected a Unix socket (SO_PEERCRED); 0 when the kernel does not say.
pid_t peer_of(int socket);

}  // namespace host
