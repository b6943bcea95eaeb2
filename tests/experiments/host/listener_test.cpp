#include "experiments/host/listener.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>

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

TEST(PrivateDirectory, IsRemovedByTheNextOneWhenItsProgramWasKilled) {
  namespace fs = std::filesystem;
  const PrivateDirectory alone;  // for this test's temporary files
  const std::string usual = fs::temp_directory_path();
  ::setenv("TMPDIR", alone.path().c_str(), 1);
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours{2};
  const fs::path left = fs::temp_directory_path() / "matchday-a1B2c3";
  const fs::path fresh = fs::temp_directory_path() / "matchday-a1B2c4";
  const fs::path of_others = fs::temp_directory_path() / "matchday-run-a1B2c3";
  for (const fs::path& one : {left, fresh, of_others}) {
    fs::create_directories(one / "deeper");
    if (one != fresh) fs::last_write_time(one, old);
  }
  const PrivateDirectory in_use;
  fs::last_write_time(in_use.path(), old);
  const PrivateDirectory next;
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(fresh)) << "its program may be about to lock it";
  EXPECT_TRUE(fs::exists(of_others)) << "a run's own, which its next run removes";
  EXPECT_TRUE(fs::exists(in_use.path())) << "somebody holds it";
  ::setenv("TMPDIR", usual.c_str(), 1);
}

}  // namespace
}  // namespace host
