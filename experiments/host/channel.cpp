#include "experiments/host/channel.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace host {
namespace {

constexpr std::size_t receive_bytes = 65536;  // far more than a reply; a longer one takes more calls

timeval as_timeval(std::chrono::milliseconds span) {
  return {.tv_sec = span.count() / 1000, .tv_usec = (span.count() % 1000) * 1000};
}

}  // namespace

Channel::Channel(int socket, std::size_t longest)
    : socket_(socket), reader_(longest), buffer_(receive_bytes) {
  const timeval limit = as_timeval(slice);
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  ::setsockopt(socket_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
}

Channel::Channel(Channel&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      reader_(std::move(other.reader_)),
      buffer_(std::move(other.buffer_)),
      bytes_in_(other.bytes_in_),
      calls_(other.calls_) {}

Channel::~Channel() {
  if (socket_ >= 0) ::close(socket_);
}

Channel::Status Channel::send(std::string_view& rest, Full full) {
  const int flags = MSG_NOSIGNAL | (full == Full::Return ? MSG_DONTWAIT : 0);
  while (!rest.empty()) {
    ++calls_;
    const ssize_t count = ::send(socket_, rest.data(), rest.size(), flags);
    if (count < 0) {
      if (errno == EINTR) continue;
      return errno == EAGAIN || errno == EWOULDBLOCK ? Status::Waiting : Status::Closed;
    }
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  return Status::Done;
}

Channel::Status Channel::receive(std::span<const std::byte>& payload) {
  while (true) {
    if (const auto frame = reader_.next()) {
      payload = *frame;
      return Status::Done;
    }
    ++calls_;
    const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (count < 0) {
      if (errno == EINTR) continue;
      return errno == EAGAIN || errno == EWOULDBLOCK ? Status::Waiting : Status::Closed;
    }
    if (count == 0) return Status::Closed;
    bytes_in_ += count;
    reader_.append({buffer_.data(), static_cast<std::size_t>(count)});
  }
}

bool Channel::has_input() const {
  pollfd watched{socket_, POLLIN, 0};
  return ::poll(&watched, 1, 0) > 0;
}

bool Channel::has_bytes() const {
  char one = 0;
  return ::recv(socket_, &one, 1, MSG_PEEK | MSG_DONTWAIT) > 0;
}

}  // namespace host
