#include "experiments/host/listener.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace host {

constexpr int waiting_room = 16;  // strangers must not keep the team out until they are seen (ours)

Listener::Listener(std::filesystem::path path) : path_(std::move(path)) {
  const std::string name = path_.string();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (name.size() >= sizeof address.sun_path) {
    throw std::runtime_error("the socket path " + name + " has " + std::to_string(name.size()) +
                             " bytes, at most 107 are possible: set TMPDIR to a shorter directory");
  }
  std::memcpy(address.sun_path, name.c_str(), name.size() + 1);

  file_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  void* raw = &address;
  if (file_ < 0 || ::bind(file_, static_cast<const sockaddr*>(raw), sizeof address) != 0 ||
      ::listen(file_, waiting_room) != 0) {
    const int error = errno;
    if (file_ >= 0) ::close(file_);
    throw std::runtime_error("cannot listen on " + name + ": " + std::generic_category().message(error));
  }
}

Listener::~Listener() { ::close(file_); }

std::optional<int> Listener::accept() {
  const int connected = ::accept4(file_, nullptr, nullptr, SOCK_CLOEXEC);
  if (connected < 0) return std::nullopt;
  return connected;
}

}  // namespace host
