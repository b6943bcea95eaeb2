#include "sim/network/udp.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <utility>
#include <vector>

namespace network {
namespace {

namespace ip = boost::asio::ip;
using boost::system::error_code;

ip::address_v4 ipv4(std::string_view text) {
  error_code error;
  const ip::address_v4 address = ip::make_address_v4(text, error);
  if (error) {
    throw NetworkError("\"" + std::string(text) + "\" is not an IPv4 address such as 127.0.0.1");
  }
  return address;
}

ip::udp::endpoint endpoint(const Address& address) { return {ipv4(address.host), address.port}; }

[[noreturn]] void fail(const std::string& what, const error_code& error) {
  throw NetworkError(what + ": " + error.message());
}

}  // namespace

struct UdpSocket::Impl {
  Impl() {
    socket.open(ip::udp::v4());
    socket.non_blocking(true);
  }

  boost::asio::io_context context;  // a socket wants one; nothing ever runs in it
  ip::udp::socket socket{context};
  std::array<char, 65536> buffer{};  // longer than any datagram, so that none arrives cut
};

std::string to_string(const Address& address) { return address.host + ":" + std::to_string(address.port); }

bool is_ipv4(std::string_view text) {
  error_code error;
  ip::make_address_v4(text, error);
  return !error;
}

bool is_multicast(std::string_view text) {
  error_code error;
  const ip::address_v4 address = ip::make_address_v4(text, error);
  return !error && address.is_multicast();
}

UdpSocket::UdpSocket(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
UdpSocket::~UdpSocket() = default;
UdpSocket::UdpSocket(UdpSocket&&) noexcept = default;
UdpSocket& UdpSocket::operator=(UdpSocket&&) noexcept = default;

UdpSocket UdpSocket::server(const Address& address) {
  auto impl = std::make_unique<Impl>();
  error_code error;
  impl->socket.bind(endpoint(address), error);
  const std::string what = "cannot listen on " + to_string(address);
  if (error == boost::asio::error::address_in_use) throw AddressInUse(what + ": " + error.message());
  if (error) fail(what, error);
  return UdpSocket(std::move(impl));
}

UdpSocket UdpSocket::multicast_sender(const std::string& interface) {
  auto impl = std::make_unique<Impl>();
  error_code error;
  impl->socket.set_option(ip::multicast::outbound_interface(ipv4(interface)), error);
  if (error) fail("cannot send multicast by the interface " + interface, error);
  impl->socket.set_option(ip::multicast::hops(1));
  impl->socket.set_option(ip::multicast::enable_loopback(true));
  return UdpSocket(std::move(impl));
}

UdpSocket UdpSocket::multicast_receiver(const Address& group, const std::string& interface) {
  auto impl = std::make_unique<Impl>();
  error_code error;
  impl->socket.set_option(ip::udp::socket::reuse_address(true));
  // Bound to the group itself: what others send to the same port does not arrive.
  impl->socket.bind(endpoint(group), error);
  if (!error) {
    impl->socket.set_option(ip::multicast::join_group(ipv4(group.host), ipv4(interface)), error);
  }
  if (error) fail("cannot hear " + to_string(group) + " on the interface " + interface, error);
  return UdpSocket(std::move(impl));
}

Address UdpSocket::local() const {
  const ip::udp::endpoint local = impl_->socket.local_endpoint();
  return {local.address().to_string(), local.port()};
}

std::optional<Datagram> UdpSocket::receive() {
  ip::udp::endpoint sender;
  error_code error;
  const std::size_t size = impl_->socket.receive_from(boost::asio::buffer(impl_->buffer), sender, 0, error);
  if (error) return std::nullopt;  // nothing there; or an old reply that did not arrive, which is no news
  return Datagram{{impl_->buffer.data(), size}, {sender.address().to_string(), sender.port()}};
}

bool UdpSocket::send(std::string_view bytes, const Address& to) {
  error_code error;
  const std::size_t sent = impl_->socket.send_to(boost::asio::buffer(bytes), endpoint(to), 0, error);
  return !error && sent == bytes.size();
}

void wait(std::span<UdpSocket* const> sockets, Clock::time_point deadline) {
  const auto left = std::max(deadline - Clock::now(), Clock::duration::zero());
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
  const timespec timeout{whole.count(), std::chrono::nanoseconds(left - whole).count()};
  std::vector<pollfd> handles;
  for (UdpSocket* socket : sockets) handles.push_back({socket->impl_->socket.native_handle(), POLLIN, 0});
  ppoll(handles.data(), handles.size(), &timeout, nullptr);
}

}  // namespace network
