#include "teams/kit/channel.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace kit {

Channel::~Channel() { ::close(descriptor_); }

int Channel::connect(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    throw std::runtime_error("MATCHDAY_SOCKET: the path \"" + path +
                             "\" is longer than a Unix socket's may be");
  }
  path.copy(address.sun_path, path.size());
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) throw std::runtime_error(std::string("no socket: ") + std::strerror(errno));
  if (::connect(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    const std::string reason = std::strerror(errno);
    ::close(descriptor);
    throw std::runtime_error("MATCHDAY_SOCKET: cannot connect to \"" + path + "\": " + reason);
  }
  return descriptor;
}

std::optional<std::span<const std::byte>> Channel::read() {
  std::array<std::byte, 1 << 16> bytes;
  while (true) {
    if (const auto frame = frames_.next()) return frame;
    ++calls_;
    const ssize_t got = ::read(descriptor_, bytes.data(), bytes.size());
    if (got > 0) {
      frames_.append(std::span(bytes.data(), static_cast<std::size_t>(got)));
    } else if (got == 0) {
      if (frames_.pending() > 0) throw std::runtime_error("the host closed the channel inside a message");
      return {};
    } else if (errno != EINTR) {
      throw std::runtime_error(std::string("reading from the host: ") + std::strerror(errno));
    }
  }
}

void Channel::write(std::string_view bytes) {
  while (!bytes.empty()) {
    ++calls_;
    const ssize_t sent = ::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(sent));
    } else if (errno != EINTR) {
      throw std::runtime_error(std::string("writing to the host: ") + std::strerror(errno));
    }
  }
}

}  // namespace kit
