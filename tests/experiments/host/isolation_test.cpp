// What a team can reach at each level of isolation, and that all else of a game goes on as it does without.

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "experiments/host/play.h"
#include "experiments/process/family.h"
#include "experiments/process/tree.h"
#include "tests/fakes/games.h"

namespace host {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using process::Isolation;
using record::Party;
using record::Termination;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class IsolatedTeams : public testing::Test {
 protected:
  IsolatedTeams() {
    const char* home = std::getenv("HOME");
    home_before_ = home != nullptr ? home : "/";
    fs::create_directories(results_ / "games");
    fs::create_directories(folder_ / "home");
    std::ofstream(results_ / "ledger.sqlite") << "results";
    std::ofstream(folder_ / "home" / "secret") << "private";
    std::ofstream("/dev/shm/matchday-test-" + std::to_string(::getpid())) << "shared";
    ::setenv("HOST_TEST", std::to_string(::getpid()).c_str(), 1);
    ::setenv("HOME", (folder_ / "home").c_str(), 1);
    ::setenv("HOST_HOME", (folder_ / "home").c_str(), 1);
    ::setenv("TRESPASS_FOLDER", results_.c_str(), 1);
    listen_on_loopback();
    listen_on_abstract();
    options_.stop_grace = 200ms;
    options_.hidden = {results_};
  }
  ~IsolatedTeams() override {
    ::close(tcp_);
    ::close(abstract_);
    fs::remove("/dev/shm/matchday-test-" + std::to_string(::getpid()));
    ::setenv("HOME", home_before_.c_str(), 1);
    process::remove_tree(folder_);
  }
  /// Whether the machine has that level; says why not.
  static bool has(Isolation level) {
    static const process::IsolationLimit limit = process::isolation_limit();
    if (limit.strongest >= level) return true;
    std::cout << "not isolated here: " << limit.problem << std::endl;
    return false;
  }

  record::MatchRecord play_at(Isolation level, const std::string& blue_mode, int at_tick = 5) {
    auto config = fakes::short_game("good", blue_mode);
    config.teams.blue.command = fakes::fake_team(blue_mode, at_tick);
    return play_at(level, config);
  }
  record::MatchRecord play_at(Isolation level, record::MatchConfig config) {
    options_.isolation = level;
    config.directory = results_ / "games" / "1";
    return play(config, options_);
  }
  std::string log(const std::string& team) const {
    std::ifstream stream(results_ / "games" / "1" / (team + ".log"));
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// What the trespasser could do.
  std::set<std::string> trespasses(Isolation level) {
    const auto record = play_at(level, "trespass");
    EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
    EXPECT_THAT(log("blue"), HasSubstr("tried all"));
    hash_ = record.hash;
    std::set<std::string> found;
    const std::string begin = "trespass: ";
    std::ifstream stream(results_ / "games" / "1" / "blue.log");
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with(begin)) found.insert(line.substr(begin.size()));
    }
    return found;
  }

  fs::path folder_ = fs::temp_directory_path() / ("isolation-" + std::to_string(::getpid()));
  fs::path results_ = folder_ / "results";
  Options options_;
  std::string hash_;

 private:
  void listen_on_loopback() {
    tcp_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    void* raw = &address;
    ASSERT_EQ(::bind(tcp_, static_cast<sockaddr*>(raw), size), 0);
    ASSERT_EQ(::listen(tcp_, 8), 0);
    ASSERT_EQ(::getsockname(tcp_, static_cast<sockaddr*>(raw), &size), 0);
    ::setenv("TRESPASS_PORT", std::to_string(ntohs(address.sin_port)).c_str(), 1);
  }
  void listen_on_abstract() {
    abstract_ = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = "matchday-test-" + std::to_string(::getpid());
    std::memcpy(&address.sun_path[1], name.data(), name.size());
    void* raw = &address;
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
    ASSERT_EQ(::bind(abstract_, static_cast<sockaddr*>(raw), size), 0);
    ASSERT_EQ(::listen(abstract_, 8), 0);
  }

  std::string home_before_;
  int tcp_ = -1;
  int abstract_ = -1;
};

TEST_F(IsolatedTeams, WithoutIsolationATeamReachesNearlyEverything) {
  const std::set<std::string> found = trespasses(Isolation::None);
  for (const char* what : {"sees the host", "sees the other team", "reads the ledger", "writes the ledger",
                           "writes a result", "reads the home", "writes beside its program",
                           "opens shared memory", "reaches TCP", "reaches an abstract socket"}) {
    EXPECT_THAT(found, Contains(what));
  }
}

TEST_F(IsolatedTeams, WithFilesOfItsOwnATeamReachesOnlyTheNetwork) {
  if (!has(Isolation::Files)) GTEST_SKIP();
  EXPECT_EQ(trespasses(Isolation::Files),
            (std::set<std::string>{"reaches TCP", "reaches an abstract socket"}));
}

TEST_F(IsolatedTeams, WithoutTheNetworkATeamReachesNothing) {
  if (!has(Isolation::Network)) GTEST_SKIP();
  EXPECT_EQ(trespasses(Isolation::Network), std::set<std::string>{});
  const std::string isolated = hash_;
  trespasses(Isolation::None);
  EXPECT_EQ(hash_, isolated) << "isolation is no part of a game";
}

TEST_F(IsolatedTeams, HowATeamEndsIsToldAsEver) {
  if (!has(Isolation::Network)) GTEST_SKIP();
  const auto reason = [&](const std::string& mode) { return play_at(Isolation::Network, mode).reason; };
  EXPECT_THAT(reason("crash"), HasSubstr("blue (Fake B) was ended by signal 11 (Segmentation fault) before"));
  EXPECT_THAT(reason("exit-at-start"), HasSubstr("blue (Fake B) ended with code 3 before it connected"));
  EXPECT_THAT(reason("exit"), HasSubstr("blue (Fake B) ended with code 0 before the game was over"));
  EXPECT_THAT(reason("fork-children"), HasSubstr("signal 11"));
  EXPECT_THAT(reason("close"), HasSubstr("closed the channel"));
  options_.reply_deadline = 1s;
  EXPECT_THAT(reason("ignore-term"), HasSubstr("did not answer within 1 s"));
}

TEST_F(IsolatedTeams, LimitsHoldAndUseIsCounted) {
  if (!has(Isolation::Network)) GTEST_SKIP();
  options_.memory_limit = std::int64_t{256} << 20;
  EXPECT_THAT(play_at(Isolation::Network, "memory").reason, HasSubstr("of memory, 256 MiB are allowed"));
  for (const std::string mode : {"hoard", "hoard-apart"}) {
    EXPECT_THAT(play_at(Isolation::Network, mode).reason, HasSubstr("of memory, 256 MiB are allowed"))
        << mode;
  }
  options_.memory_limit = std::int64_t{128} << 20;  // its folder has room for 256 MiB
  EXPECT_THAT(play_at(Isolation::Network, "hoard-tmp").reason, HasSubstr("of memory, 128 MiB are allowed"));
  EXPECT_THAT(play_at(Isolation::Network, "connect-twice").reason, HasSubstr("connected a second time"));
  options_.memory_limit = 0;
  const auto record = play_at(Isolation::Network, "chatter");
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  // 2400 ticks of 20 kB take more than a step of the clock, 0.01 s; a fake team holds more than 1 MiB.
  EXPECT_GT(record.costs.at("user_seconds_blue") + record.costs.at("system_seconds_blue"), 0.01);
  EXPECT_GT(record.costs.at("peak_memory_blue"), 1 << 20);
}

TEST_F(IsolatedTeams, NothingIsLeftOfDaemons) {
  if (!has(Isolation::Files)) GTEST_SKIP();
  const auto record = play_at(Isolation::Files, "daemons");
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  EXPECT_EQ(process::started_with("HOST_TEST=" + std::to_string(::getpid())), std::vector<pid_t>{});
}

TEST_F(IsolatedTeams, WhatCannotBeStartedIsToldAsEver) {
  if (!has(Isolation::Network)) GTEST_SKIP();
  auto config = fakes::short_game("good", "good");
  config.teams.blue.command = {"/nowhere/team"};
  EXPECT_THAT(play_at(Isolation::Network, config).reason,
              HasSubstr("blue (Fake B) did not start: program '/nowhere/team' does not exist"));

  const fs::path script = folder_ / "script";
  std::ofstream(script) << "#!/nowhere/interpreter\n";
  ::chmod(script.c_str(), 0755);
  config.teams.blue.command = {script.string()};
  const auto record = play_at(Isolation::Network, config);
  EXPECT_EQ(record.termination, Termination::NotStarted) << record.reason;
  EXPECT_EQ(record.at_fault, Party::Blue);
  EXPECT_THAT(record.reason, HasSubstr("cannot be executed: No such file or directory"));
}

TEST_F(IsolatedTeams, ATeamFindsWhatItsCommandNamesWhereverThatIs) {
  if (!has(Isolation::Network)) GTEST_SKIP();
  // In a checkout below the hidden result folder, in the home, in the folder for temporary files.
  auto config = fakes::short_game("good", "good");
  for (const fs::path& place : {results_ / "builds" / "one", folder_ / "home" / "team", folder_ / "tool"}) {
    fs::create_directories(place);
    std::ofstream(place / "settings") << "found";
    std::ofstream(place / "team.sh")
        << "cat settings; echo; ls \"$HOME\"; cat \"$1\"; exec \"$2\" --mode good\n";
    std::ofstream(folder_ / "home" / "model") << " model";
    config.teams.blue.directory = place;
    config.teams.blue.command = {"/bin/sh", "./team.sh", (folder_ / "home" / "model").string(),
                                 fakes::bin_dir() + "/fake-team"};
    const auto record = play_at(Isolation::Network, config);
    EXPECT_EQ(record.termination, Termination::Finished) << place << record.reason << log("blue");
    EXPECT_THAT(log("blue"), HasSubstr("found"));
    EXPECT_THAT(log("blue"), HasSubstr("model"));
    EXPECT_THAT(log("blue"), Not(HasSubstr("secret")));
  }
}

TEST_F(IsolatedTeams, ATeamWritesIntoItsOwnLogFolderOnly) {
  if (!has(Isolation::Network)) GTEST_SKIP();
  auto config = fakes::short_game("good", "good");
  config.teams.blue.command = {"/bin/sh", "-c",
                               "for d in blue yellow . ..; do touch " + (results_ / "games" / "1").string() +
                                   "/$d/mine && echo wrote $d; done; exec " + fakes::bin_dir() +
                                   "/fake-team --mode good"};
  const auto record = play_at(Isolation::Network, config);
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason << log("blue");
  EXPECT_TRUE(fs::exists(results_ / "games" / "1" / "blue" / "mine"));
  EXPECT_THAT(log("blue"), HasSubstr("wrote blue"));
  for (const char* other : {"wrote yellow", "wrote ."}) EXPECT_THAT(log("blue"), Not(HasSubstr(other)));
}

}  // namespace
}  // namespace host
