#include "experiments/runner/run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <thread>

#include "experiments/record/ledger.h"
#include "tests/experiments/runner/run_fixture.h"

namespace runner {
namespace {

using testing::HasSubstr;

TEST_F(RunTest, PlaysEveryGameOnce) {
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a").size(), 16U);
  EXPECT_THAT(said_, HasSubstr("16/16 games"));
  EXPECT_FALSE(fs::exists(folder_.path() / "a/games")) << "good games leave no files";
  EXPECT_TRUE(fs::exists(folder_.path() / "a/manifest.json"));
}

TEST_F(RunTest, DoesNothingWhenAllIsThere) {
  play(options("a"));
  EXPECT_EQ(play(options("a")), Ending::Done);
  EXPECT_EQ(table("a").size(), 16U);
  EXPECT_THAT(said_, HasSubstr("16 of 16 games are there"));
}

TEST_F(RunTest, GivesTheSameTableWithAnyNumberOfWorkers) {
  RunOptions one = options("one");
  one.workers = 1;
  RunOptions five = options("five");
  five.workers = 5;
  play(one);
  play(five);
  EXPECT_EQ(table("one"), table("five"));
}

TEST_F(RunTest, KilledAtAnyMomentAndContinuedGivesTheSameTable) {
  const std::vector<std::string> fake = {"--milliseconds", "20", "--fail", "first"};
  design_ = small_design(12);
  play(options("undisturbed", fake));
  const std::vector<record::Attempt> expected = table("undisturbed");
  ASSERT_GT(expected.size(), 48U) << "some games should have been void";

  // Twenty moments: before the folder exists, while the ledger is made, during the first games, later. Each
  // run gets on, by a game or two.
  std::mt19937 random(20);  // fixed: the same moments in every run of the test
  std::uniform_int_distribution<int> moment(0, 90);
  for (int kill = 0; kill < 20; ++kill) {
    const int milliseconds = kill < 3 ? 3 * kill : moment(random);
    const pid_t child = play_elsewhere(options("disturbed", fake));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    EXPECT_TRUE(nobody_left()) << "after " << milliseconds << " ms";
  }
  EXPECT_EQ(play(options("disturbed", fake)), Ending::Done);

  EXPECT_EQ(counted(table("disturbed")), counted(expected));
}

TEST_F(RunTest, StopsOnASignalWithoutLeavingAnyoneAndContinues) {
  const std::vector<std::string> slow = {"--milliseconds", "100"};
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t child = play_elsewhere(options("a", slow));
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 128 + signal);
    EXPECT_EQ(left_over(), 0);
  }
  const std::size_t before = table("a").size();
  EXPECT_GT(before, 0U);
  EXPECT_LT(before, 16U);
  EXPECT_EQ(play(options("a")), Ending::Done);
  play(options("b"));
  EXPECT_EQ(table("a"), table("b"));
}

struct Fault {
  const char* how;
  const char* reason;
};
class RunFault : public RunTest, public testing::WithParamInterface<Fault> {};

TEST_P(RunFault, IsAVoidAttemptWithItsReasonAndThePairIsPlayedAgain) {
  design_ = small_design(1);
  RunOptions faulty = options("a", {"--fail", "always", "--how", GetParam().how});
  // Only the limit in question is short: on a busy machine another would come first.
  const std::string how = GetParam().how;
  faulty.start_up = std::chrono::milliseconds{how == "hang" ? 200 : 60'000};
  faulty.limits.silence = how == "stuck" ? 0.2 : 60;
  faulty.limits.game = how == "long" ? 0.6 : 60;
  faulty.workers = 1;
  EXPECT_EQ(play(faulty), Ending::TooManyFaults);
  EXPECT_THAT(said_, HasSubstr("2 pairs were given up after 3 void attempts"));
  EXPECT_TRUE(nobody_left());
  const auto attempts = table("a");
  ASSERT_EQ(attempts.size(), 6U) << "the second leg is not started once the first is void";
  for (const record::Attempt& attempt : attempts) {
    EXPECT_EQ(record::outcome(attempt.record), record::Outcome::Void);
    EXPECT_THAT(attempt.record.reason, HasSubstr(GetParam().reason));
  }
  EXPECT_TRUE(fs::exists(folder_.path() / "a/games/equal-0000-0/3/worker.log")) << "evidence is kept";
}

INSTANTIATE_TEST_SUITE_P(All, RunFault,
                         testing::Values(Fault{"crash", "was ended by signal 9"},
                                         Fault{"abort", "it said last: assertion failed: ball is round"},
                                         Fault{"exit", "ended with code 3"},
                                         Fault{"hang", "the worker did not begin to play within 0.2 s"},
                                         Fault{"stuck", "stuck at 12.5 s of the match: no simulated time"},
                                         Fault{"long", "the game took longer than 0.6 s"},
                                         Fault{"silent", "left no usable result"},
                                         Fault{"nonsense", "left no usable result"}),
                         [](const auto& instance) { return std::string(instance.param.how); });

TEST(WorkerLimits, AreTheDesigns) {
  schedule::Limits limits;
  limits.silence = 7;
  limits.game = 70;
  limits.output = 9;
  const WorkerLimits found = worker_limits(limits);
  EXPECT_EQ(found.silence, std::chrono::seconds{7});
  EXPECT_EQ(found.game, std::chrono::seconds{70});
  EXPECT_EQ(found.output, std::size_t{9} << 20);
}

TEST_F(RunTest, CountsAForfeitAndKeepsItsFiles) {
  EXPECT_EQ(play(options("a", {"--fail", "first", "--how", "forfeit"})), Ending::Done);
  EXPECT_EQ(table("a").size(), 16U);
  int forfeits = 0;
  for (const record::Attempt& attempt : table("a")) {
    if (attempt.record.at_fault == record::Party::Nobody) continue;
    ++forfeits;
    EXPECT_TRUE(fs::exists(folder_.path() / "a/games" / record::game_id(attempt.key) / "1"));
  }
  EXPECT_GT(forfeits, 0);
}

TEST_F(RunTest, StopsAfterTooManyFaultsInARow) {
  RunOptions faulty = options("a", {"--fail", "always", "--how", "exit"});
  faulty.limits.faults_in_a_row = 4;
  faulty.workers = 1;
  EXPECT_EQ(play(faulty), Ending::TooManyFaults);
  EXPECT_EQ(table("a").size(), 4U);
  EXPECT_THAT(said_, HasSubstr("4 games in a row were void"));
  for (const auto& attempt : table("a"))
    EXPECT_EQ(attempt.attempt, 1) << "no pair loses all its attempts at once";
}

TEST_F(RunTest, RefusesAFolderThatAnotherRunHolds) {
  const pid_t child = play_elsewhere(options("a", {"--milliseconds", "200"}));
  while (!fs::exists(folder_.path() / "a/manifest.json"))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  try {
    play(options("a"));
    ADD_FAILURE();
  } catch (const record::StorageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("another run is writing there"));
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

TEST_F(RunTest, RefusesAFolderOfAnotherExperiment) {
  play(options("a"));
  design_.seed = 12;
  EXPECT_THROW(play(options("a")), record::StorageError);
}

TEST_F(RunTest, StartsNothingWhenAProgramIsMissing) {
  design_.conditions[1].b.command = {"no-such-team"};
  EXPECT_THROW(play(options("a")), std::invalid_argument);
  EXPECT_FALSE(fs::exists(folder_.path() / "a"));
}

TEST_F(RunTest, WritesWhatIsNeededToMakeTheFolderAgain) {
  RunOptions named = options("a");
  named.command_line = {"matchday", "run", "small.toml"};
  named.version = "0.1.0";
  design_.text = "name = \"small\"\n";
  play(named);
  std::ifstream stream(folder_.path() / "a/manifest.json");
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::string hash = record::Ledger::read(folder_.path() / "a/ledger.sqlite").experiment().hash;
  for (const std::string& part :
       {hash, std::string("\"small.toml\""), std::string("\"compiler\""), std::string("\"commit\""),
        std::string("\"processor\""), std::string("name = \\\"small\\\"\\n"), std::string("\"xxh3_128\"")}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

}  // namespace
}  // namespace runner
