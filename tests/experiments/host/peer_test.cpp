#include "experiments/host/peer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/host/play.h"
#include "tests/fakes/games.h"

namespace host {
namespace {

using record::Party;
using record::Termination;
using testing::HasSubstr;

/// The sockets of the living teams that were started by this test.
std::vector<std::string> sockets() {
  const std::string name = "MATCHDAY_SOCKET=";
  const std::string ours = "HOST_TEST=" + std::to_string(::getpid());
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "environ");
    std::string socket;
    bool is_ours = false;
    for (std::string line; std::getline(file, line, '\0');) {
      if (line.starts_with(name)) socket = line.substr(name.size());
      is_ours = is_ours || line == ours;
    }
    if (is_ours && !socket.empty()) found.push_back(socket);
  }
  return found;
}

int connect_to(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  void* raw = &address;
  EXPECT_EQ(::connect(socket, static_cast<sockaddr*>(raw), sizeof address), 0) << path;
  return socket;
}

class Peers : public testing::Test {
 protected:
  Peers() { ::setenv("HOST_TEST", std::to_string(::getpid()).c_str(), 1); }
};

TEST_F(Peers, ATeamThatConnectsTwiceForfeits) {
  const auto record = play(fakes::short_game("good", "connect-twice"));
  EXPECT_EQ(record.at_fault, Party::Blue) << record.reason;
  EXPECT_EQ(record.termination, Termination::Nonsense);
  EXPECT_THAT(record.reason, HasSubstr("blue (Fake B) connected a second time to its socket"));
  EXPECT_LE(record.ticks, 121);  // seen at a whole second: the one after the fifth tick, or the next
}

TEST_F(Peers, ATeamThatTakesTheOthersPlaceForfeitsAndTheOtherIsNotBlamed) {
  for (const bool yellow : {true, false}) {
    const auto record =
        yellow ? play(fakes::short_game("intrude", "good")) : play(fakes::short_game("good", "intrude"));
    EXPECT_EQ(record.at_fault, yellow ? Party::Yellow : Party::Blue) << record.reason;
    EXPECT_THAT(record.reason, HasSubstr("connected to the socket of the other team"));
  }
}

TEST_F(Peers, ATeamThatConnectsToTheOtherDuringTheGameForfeits) {
  const auto record = play(fakes::short_game("intrude-late", "good"));
  EXPECT_EQ(record.at_fault, Party::Yellow) << record.reason;
  EXPECT_THAT(record.reason, HasSubstr("yellow (Fake Y) connected to the socket of the other team"));
}

TEST_F(Peers, AStrangerDecidesNothing) {
  const auto alone = play(fakes::short_game("wander", "wander"));
  ASSERT_EQ(alone.termination, Termination::Finished) << alone.reason;

  Options options;
  std::vector<int> connected;
  options.on_second = [&](world::Time, const world::PerTeam<int>&) {
    if (!connected.empty()) return;
    for (const std::string& socket : sockets()) connected.push_back(connect_to(socket));
  };
  const auto visited = play(fakes::short_game("wander", "wander"), options);
  EXPECT_EQ(connected.size(), 2U);
  EXPECT_EQ(visited.termination, Termination::Finished) << visited.reason;
  EXPECT_EQ(visited.hash, alone.hash);
  EXPECT_EQ(visited.costs.at("refused_connections_yellow"), 1);
  EXPECT_EQ(visited.costs.at("refused_connections_blue"), 1);
  for (const int socket : connected) {
    char byte = 0;
    EXPECT_EQ(::recv(socket, &byte, 1, 0), 0) << "it was not closed";
    ::close(socket);
  }
}

TEST_F(Peers, ATeamThatHasLeftItsParentsBeforeItConnectsPlays) {
  const auto record = play(fakes::short_game("apart", "good"));
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  EXPECT_FALSE(record.costs.contains("refused_connections_yellow"));
}

TEST_F(Peers, NoTeamsEnvironmentNamesTheOthersSocket) {
  Options options;
  std::vector<std::string> paths;
  options.on_second = [&](world::Time, const world::PerTeam<int>&) {
    if (paths.empty()) paths = sockets();
  };
  play(fakes::short_game("good", "good"), options);
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_NE(std::filesystem::path(paths[0]).parent_path(), std::filesystem::path(paths[1]).parent_path());
}

}  // namespace
}  // namespace host
