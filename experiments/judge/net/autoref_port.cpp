#include "experiments/judge/net/autoref_port.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "sim/wire/delimited.h"

namespace judge {

namespace proto = matchday::referee;

struct AutorefPort::Client {
  explicit Client(int its) : socket(its) {}
  ~Client() { ::close(socket); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  /// False when it does not take it: replies are a few bytes, so it has long stopped reading.
  bool reply(proto::ControllerReply::StatusCode status, const char* reason = nullptr) const {
    proto::ControllerToAutoRef message;
    proto::ControllerReply& reply = *message.mutable_controller_reply();
    reply.set_status_code(status);
    reply.set_verification(proto::ControllerReply::UNVERIFIED);
    if (reason != nullptr) reply.set_reason(reason);
    std::string bytes;
    wire::append_frame(bytes, message);
    return ::send(socket, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL) ==
           static_cast<ssize_t>(bytes.size());
  }

  int socket;
  wire::FrameReader frames;
  bool registered = false;
};

AutorefPort::AutorefPort() {
  const auto fail = [](const char* what) {
    throw std::system_error(errno, std::generic_category(), std::string("autoref port 10007: ") + what);
  };
  socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0) fail("no socket");
  const int yes = 1;
  ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_ANY);
  address.sin_port = htons(number);
  sockaddr* const any = reinterpret_cast<sockaddr*>(&address);
  if (::bind(socket_, any, sizeof address) != 0 || ::listen(socket_, 4) != 0) fail("cannot listen");
}

AutorefPort::~AutorefPort() {
  clients_.clear();
  ::close(socket_);
}

void AutorefPort::listen(std::vector<proto::GameEvent>& events) {
  for (int fd = 0; (fd = ::accept4(socket_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)) >= 0;) {
    auto client = std::make_unique<Client>(fd);
    if (client->reply(proto::ControllerReply::OK)) clients_.push_back(std::move(client));
  }
  std::erase_if(clients_, [&](const auto& client) { return !hear(*client, events); });
}

bool AutorefPort::hear(Client& client, std::vector<proto::GameEvent>& events) {
  std::array<std::byte, 4096> bytes;
  while (true) {
    const ssize_t size = ::recv(client.socket, bytes.data(), bytes.size(), 0);
    if (size == 0) return false;
    if (size < 0) return errno == EAGAIN || errno == EINTR;
    client.frames.append(std::span(bytes).first(static_cast<std::size_t>(size)));
    try {
      while (const auto frame = client.frames.next()) {
        const int length = static_cast<int>(frame->size());
        if (!client.registered) {
          proto::AutoRefRegistration registration;
          const bool readable = registration.ParseFromArray(frame->data(), length);
          if (!readable || registration.identifier().empty()) {
            client.reply(proto::ControllerReply::REJECTED, "a registration with an identifier comes first");
            return false;
          }
          client.registered = true;
          registered_.push_back(registration.identifier());
        } else {
          proto::AutoRefToController message;
          if (!message.ParseFromArray(frame->data(), length)) return false;
          if (message.has_game_event()) events.push_back(message.game_event());
        }
        if (!client.reply(proto::ControllerReply::OK)) return false;
      }
    } catch (const wire::FrameError&) {
      return false;
    }
  }
}

}  // namespace judge
