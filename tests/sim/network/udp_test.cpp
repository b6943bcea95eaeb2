#include "sim/network/udp.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace {

using network::Address;
using network::UdpSocket;
using testing::AllOf;
using testing::HasSubstr;

constexpr const char* loopback = "127.0.0.1";
// A group of our own ("administratively scoped"), so that a real simulator on this machine is not heard.
constexpr const char* group = "239.255.42.17";

/// The next datagram; nothing after a second without one, thousands of times what loopback takes.
std::optional<std::string> next(UdpSocket& socket) {
  UdpSocket* const sockets[] = {&socket};
  const auto deadline = network::Clock::now() + std::chrono::seconds{1};
  while (network::Clock::now() < deadline) {
    if (const auto datagram = socket.receive()) return std::string(datagram->bytes);
    network::wait(sockets, deadline);
  }
  return std::nullopt;
}

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const network::NetworkError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(UdpSocket, AnswersTheSender) {
  UdpSocket server = UdpSocket::server({loopback, 0});
  UdpSocket client = UdpSocket::server({loopback, 0});
  ASSERT_NE(server.local().port, 0);
  ASSERT_TRUE(client.send("question", server.local()));

  UdpSocket* const sockets[] = {&server};
  network::wait(sockets, network::Clock::now() + std::chrono::seconds{1});
  const auto datagram = server.receive();
  ASSERT_TRUE(datagram);
  EXPECT_EQ(datagram->bytes, "question");
  EXPECT_EQ(datagram->sender, client.local());
  ASSERT_TRUE(server.send("answer", datagram->sender));
  EXPECT_EQ(next(client), "answer");
  EXPECT_FALSE(client.receive()) << "and no more";
}

TEST(UdpSocket, CarriesWholeDatagramsFromEmptyToTheLargest) {
  UdpSocket server = UdpSocket::server({loopback, 0});
  UdpSocket client = UdpSocket::server({loopback, 0});
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{8193}, network::max_udp_payload}) {
    ASSERT_TRUE(client.send(std::string(size, 'x'), server.local()));
    EXPECT_EQ(next(server), std::string(size, 'x'));
  }
  EXPECT_FALSE(client.send(std::string(network::max_udp_payload + 1, 'x'), server.local()));
}

TEST(UdpSocket, MulticastReachesEveryReceiverOfTheGroupOnLoopback) {
  UdpSocket first = UdpSocket::multicast_receiver({group, 0}, loopback);
  const Address address{group, first.local().port};
  UdpSocket second = UdpSocket::multicast_receiver(address, loopback);
  UdpSocket elsewhere = UdpSocket::multicast_receiver({"239.255.42.18", address.port}, loopback);
  UdpSocket sender = UdpSocket::multicast_sender(loopback);
  ASSERT_TRUE(sender.send("frame", address));
  EXPECT_EQ(next(first), "frame");
  EXPECT_EQ(next(second), "frame");
  EXPECT_FALSE(elsewhere.receive()) << "another group on the same port";
}

TEST(UdpSocket, ATakenPortIsOneSentence) {
  const UdpSocket first = UdpSocket::server({loopback, 0});
  EXPECT_EQ(error_of([&] { UdpSocket::server(first.local()); }),
            "cannot listen on " + to_string(first.local()) + ": Address already in use");
}

TEST(UdpSocket, SaysWhatIsWrongWithAnAddress) {
  EXPECT_THAT(error_of([] {
                UdpSocket::server({"localhost", 0});
              }),
              AllOf(HasSubstr("\"localhost\""), HasSubstr("not an IPv4 address")));
  // 192.0.2.0/24 is set aside for documents: no machine has such an address.
  EXPECT_THAT(error_of([] { UdpSocket::server({"192.0.2.1", 0}); }), HasSubstr("192.0.2.1:0"));
  EXPECT_THAT(error_of([] { UdpSocket::multicast_sender("192.0.2.1"); }), HasSubstr("192.0.2.1"));
  EXPECT_THAT(error_of([] {
                UdpSocket::multicast_receiver({"10.1.1.1", 0}, loopback);
              }),
              HasSubstr("10.1.1.1"));
}

TEST(UdpSocket, WaitingEndsAtItsDeadlineAndWithADatagram) {
  UdpSocket server = UdpSocket::server({loopback, 0});
  UdpSocket* const sockets[] = {&server};
  const auto begin = network::Clock::now();
  network::wait(sockets, begin + std::chrono::milliseconds{20});
  EXPECT_GE(network::Clock::now(), begin + std::chrono::milliseconds{20});
  network::wait(sockets, begin);  // a deadline in the past does not wait

  UdpSocket client = UdpSocket::server({loopback, 0});
  ASSERT_TRUE(client.send("x", server.local()));
  network::wait(sockets, network::Clock::now() + std::chrono::hours{1});  // else the test never ends
  EXPECT_TRUE(server.receive());
}

TEST(Address, KnowsMulticastGroups) {
  EXPECT_TRUE(network::is_multicast("224.5.23.2"));
  EXPECT_TRUE(network::is_multicast("239.255.255.255"));
  EXPECT_FALSE(network::is_multicast("127.0.0.1"));
  EXPECT_FALSE(network::is_multicast("240.0.0.1"));
  EXPECT_FALSE(network::is_multicast("vision"));
  EXPECT_TRUE(network::is_ipv4("0.0.0.0"));
  EXPECT_FALSE(network::is_ipv4("1.2.3"));
  EXPECT_FALSE(network::is_ipv4(""));
}
