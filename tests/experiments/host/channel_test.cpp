#include "experiments/host/channel.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <string>
#include <thread>

namespace host {
namespace {

class ChannelTest : public testing::Test {
 protected:
  ChannelTest() : ends_(pair()), channel_(ends_[0]), peer_(ends_[1]) {}
  ~ChannelTest() override { hang_up(); }

  static std::array<int, 2> pair() {
    std::array<int, 2> ends{};
    EXPECT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
    return ends;
  }
  void peer_sends(const std::string& bytes) const {
    ASSERT_EQ(::send(peer_, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  }
  void hang_up() {
    if (peer_ >= 0) ::close(peer_);
    peer_ = -1;
  }
  Channel::Status receive(std::string& text) {
    std::span<const std::byte> payload;
    const Channel::Status status = channel_.receive(payload);
    text.clear();
    for (const std::byte byte : payload) text += static_cast<char>(byte);
    return status;
  }

  std::array<int, 2> ends_;
  Channel channel_;
  int peer_;
};

TEST_F(ChannelTest, PutsAFrameTogetherFromPieces) {
  std::string text;
  peer_sends(std::string("\x05") + "ab");
  EXPECT_EQ(receive(text), Channel::Status::Waiting);
  peer_sends("cde");
  EXPECT_EQ(receive(text), Channel::Status::Done);
  EXPECT_EQ(text, "abcde");
}

TEST_F(ChannelTest, KeepsTheSecondOfTwoFramesThatCameTogether) {
  std::string text;
  peer_sends(std::string("\x01") + "a" + "\x02" + "bc");
  EXPECT_EQ(receive(text), Channel::Status::Done);
  EXPECT_EQ(receive(text), Channel::Status::Done);
  EXPECT_EQ(text, "bc");
  EXPECT_EQ(channel_.bytes_in(), 5);
}

TEST_F(ChannelTest, ReadsWhatCameBeforeThePeerHungUp) {
  std::string text;
  peer_sends(std::string("\x01") + "a");
  hang_up();
  EXPECT_EQ(receive(text), Channel::Status::Done);
  EXPECT_EQ(receive(text), Channel::Status::Closed);
  std::string_view rest = "x";
  EXPECT_EQ(channel_.send(rest, Channel::Full::Wait), Channel::Status::Closed);
}

TEST_F(ChannelTest, ThrowsForALengthThatIsNone) {
  std::string text;
  peer_sends(std::string("\xff\xff\xff\xff\xff\xff\xff\xff"));
  EXPECT_THROW(receive(text), wire::FrameError);
}

TEST_F(ChannelTest, AFullSocketIsWaitedForInSlicesAndTheRestGoesLater) {
  const std::string large(std::size_t{4} << 20, 'x');  // far above what a socket holds (net.core.wmem_max)
  std::string_view rest = large;
  EXPECT_EQ(channel_.send(rest, Channel::Full::Wait), Channel::Status::Waiting);
  EXPECT_LT(rest.size(), large.size());
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < 100; ++i)
    EXPECT_EQ(channel_.send(rest, Channel::Full::Return), Channel::Status::Waiting);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 50 * Channel::slice) << "some microseconds each";
  std::size_t received = 0;
  std::thread reader([&] {
    std::array<char, 65536> buffer{};
    while (received < large.size()) {
      const ssize_t count = ::recv(peer_, buffer.data(), buffer.size(), 0);
      if (count <= 0) return;
      received += static_cast<std::size_t>(count);
    }
  });
  while (channel_.send(rest, Channel::Full::Wait) == Channel::Status::Waiting) {
  }
  reader.join();
  EXPECT_EQ(received, large.size());
}

}  // namespace
}  // namespace host
