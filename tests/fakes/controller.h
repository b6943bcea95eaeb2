#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>
#include <string>

#include "sim/proto/autoref.pb.h"
#include "sim/wire/delimited.h"

namespace fakes {

namespace proto = matchday::referee;

/// The game controller's port for autorefs, as one of them sees it.
class Controller {
 public:
  /// Connects and registers.
  /// @throws std::runtime_error
  Controller(const std::string& host, const std::string& name)
      : name_(name), socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(10007);
    ::inet_pton(AF_INET, host.c_str(), &address.sin_addr);
    if (::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error(name_ + ": cannot connect to " + host);
    }
    expect_ok();
    proto::AutoRefRegistration registration;
    registration.set_identifier(name_);
    send(registration);
  }
  ~Controller() { ::close(socket_); }
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  void send(const google::protobuf::MessageLite& message) {
    std::string bytes;
    wire::append_frame(bytes, message);
    if (::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size())) {
      throw std::runtime_error(name_ + ": the controller is gone");
    }
    expect_ok();
  }

 private:
  void expect_ok() {
    while (true) {
      if (const auto frame = frames_.next()) {
        proto::ControllerToAutoRef reply;
        reply.ParseFromArray(frame->data(), static_cast<int>(frame->size()));
        if (reply.controller_reply().status_code() == proto::ControllerReply::OK) return;
        throw std::runtime_error(name_ + ": refused: " + reply.controller_reply().reason());
      }
      std::byte bytes[512];
      const ssize_t size = ::recv(socket_, bytes, sizeof bytes, 0);
      if (size <= 0) throw std::runtime_error(name_ + ": the controller is gone");
      frames_.append(std::span(bytes).first(static_cast<std::size_t>(size)));
    }
  }

  std::string name_;
  int socket_;
  wire::FrameReader frames_;
};

}  // namespace fakes
