#include "experiments/host/listener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

#include "experiments/host/private_directory.h"

namespace host {
namespace {

TEST(Listener, AcceptsWhoCameAndDoesNotWait) {
  const PrivateDirectory directory;
  Listener listener(directory.path() / "socket");
  EXPECT_FALSE(listener.accept());

  const int client = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, listener.path().c_str(), sizeof address.sun_path - 1);
  void* raw = &address;
  ASSERT_EQ(::connect(client, static_cast<sockaddr*>(raw), sizeof address), 0);
  const auto server = listener.accept();
  ASSERT_TRUE(server);
  ::close(*server);
  ::close(client);
}

TEST(Listener, RefusesAPathThatDoesNotFitASocketAddress) {
  const std::string path = "/tmp/" + std::string(103, 'x');
  EXPECT_THAT([&] { Listener listener(path); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("has 108 bytes, at most 107")));
}

TEST(PrivateDirectory, IsOursAloneAndGoneAfterwards) {
  std::filesystem::path path;
  {
    const PrivateDirectory directory;
    path = directory.path();
    struct stat status {};
    ASSERT_EQ(::stat(path.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0700U);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace host
