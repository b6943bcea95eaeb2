#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace network {

using Clock = std::chrono::steady_clock;

/// An IPv4 address and a port.
struct Address {
  std::string host;        ///< in dots: 127.0.0.1
  std::uint16_t port = 0;  ///< 0 in a request: any free one
  bool operator==(const Address&) const = default;
};

/// "127.0.0.1:10300"
std::string to_string(const Address& address);

/// Says whether the text is an IPv4 address in dots.
bool is_ipv4(std::string_view text);
/// Says whether the text is an IPv4 address of a multicast group: 224.0.0.0 to 239.255.255.255.
bool is_multicast(std::string_view text);

/// A socket could not be made; the text is one sentence that names the address and says why.
class NetworkError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Another socket listens there already.
class AddressInUse : public NetworkError {
 public:
  using NetworkError::NetworkError;
};

/// Bytes that came, and from where.
struct Datagram {
  std::string_view bytes;  ///< whole, up to 65507; until the next `receive` of the same socket
  Address sender;
};

/// The longest payload of a UDP datagram over IPv4.
inline constexpr std::size_t max_udp_payload = 65507;

/// A UDP socket that never blocks. Wait for several with `wait`.
class UdpSocket {
 public:
  /// Listens on one address, alone: a second socket on it is an error.
  /// @throws AddressInUse, or another NetworkError
  static UdpSocket server(const Address& address);
  /// Sends to a multicast group by the interface that has the address `interface`; it does not leave the
  /// local network (TTL 1), and programs on this machine hear it too.
  /// @throws NetworkError
  static UdpSocket multicast_sender(const std::string& interface);
  /// Hears a multicast group on the interface that has the address `interface`; several programs may.
  /// @throws NetworkError
  static UdpSocket multicast_receiver(const Address& group, const std::string& interface);

  ~UdpSocket();
  UdpSocket(UdpSocket&&) noexcept;
  UdpSocket& operator=(UdpSocket&&) noexcept;

  Address local() const;  ///< with the port it was given when any was asked for

  /// The next datagram that has come; nothing when there is none.
  std::optional<Datagram> receive();
  /// Sends one datagram.
  /// @returns false when the system refused it, e.g. without a route
  bool send(std::string_view bytes, const Address& to);

 private:
  friend void wait(std::span<UdpSocket* const> sockets, Clock::time_point deadline);
  struct Impl;
  explicit UdpSocket(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Sleeps until a datagram is waiting at one of the sockets, at the latest until `deadline`; also ends when
/// the program handles a signal.
void wait(std::span<UdpSocket* const> sockets, Clock::time_point deadline);

}  // namespace network
