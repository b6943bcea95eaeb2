// The same game goes the same way, whoever plays beside it.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/host/play.h"
#include "tests/fakes/games.h"
#include "tests/fakes/programs.h"

namespace {

record::MatchConfig game_of_chasers() {
  auto config = fakes::short_game("good", "good");
  for (const world::Team team : world::both_teams)
    config.teams[team].command = {fakes::bin_dir() + "/team-chaser"};
  config.half_length = 20;
  return config;
}

// The game's hash, played in a process of its own as a worker would.
class Worker {
 public:
  explicit Worker(const record::MatchConfig& config) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    process_ = ::fork();
    if (process_ == 0) {
      const std::string hash = host::play(config).hash;
      const bool sent = ::write(ends[1], hash.data(), hash.size()) == static_cast<ssize_t>(hash.size());
      ::_exit(sent ? 0 : 1);
    }
    ::close(ends[1]);
    result_ = ends[0];
  }
  std::string hash() const {
    std::array<char, 32> digits{};
    const ssize_t count = ::read(result_, digits.data(), digits.size());
    ::close(result_);
    ::waitpid(process_, nullptr, 0);
    return count == 32 ? std::string(digits.data(), digits.size()) : "no hash";
  }

 private:
  pid_t process_ = -1;
  int result_ = -1;
};

TEST(Determinism, ManyGamesAtOnceGiveTheHashOfOneAlone) {
  const auto config = game_of_chasers();
  const auto alone = host::play(config);
  ASSERT_EQ(alone.termination, record::Termination::Finished) << alone.reason;
  EXPECT_GT(alone.counters.at("ball_in_play_seconds"), 5);  // of 40: a game in which something happens
  std::vector<Worker> workers;
  for (int i = 0; i < 3; ++i) workers.emplace_back(config);
  for (const Worker& worker : workers) EXPECT_EQ(worker.hash(), alone.hash);
}

TEST(Determinism, LogsAndOutputFilesChangeNothing) {
  auto config = game_of_chasers();
  const auto plain = host::play(config);
  config.directory =
      std::filesystem::path(testing::TempDir()) / ("determinism_test_" + std::to_string(::getpid()));
  config.log = config.directory / "game.log";
  EXPECT_EQ(host::play(config).hash, plain.hash);
  std::filesystem::remove_all(config.directory);
}

TEST(Determinism, OtherEndsAndAnotherKickoffAreOtherGames) {
  auto config = game_of_chasers();
  const auto first = host::play(config);
  config.blue_on_positive_half = !config.blue_on_positive_half;
  const auto swapped = host::play(config);
  EXPECT_NE(first.hash, swapped.hash);
  config.first_kickoff = world::opponent(config.first_kickoff);
  EXPECT_NE(host::play(config).hash, swapped.hash);
}

}  // namespace
