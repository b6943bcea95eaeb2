// Teams that do not answer, but arrange that the machine seems to blame: the game is theirs to lose, not
// void.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>
#include <vector>

#include "experiments/host/play.h"
#include "tests/fakes/games.h"

namespace host {
namespace {

using namespace std::chrono_literals;
using record::Party;
using record::Termination;
using testing::HasSubstr;

/// On one processor, as in a run; half a second for a reply, and as much of waits for the disk in a game.
class SlyTeams : public testing::Test {
 protected:
  SlyTeams() {
    options_.cpu = ::sched_getcpu();
    options_.stop_grace = 100ms;
    options_.reply_deadline = 500ms;
    options_.disk_wait = 500ms;
  }
  void expect_forfeit(const std::string& mode, const std::string& within = " within 0.5 s") {
    const auto record = play(fakes::short_game("good", mode), options_);
    EXPECT_EQ(record::name(record.termination), std::string(record::name(Termination::NotResponding)));
    EXPECT_EQ(record.at_fault, Party::Blue) << mode;
    EXPECT_THAT(record.reason, HasSubstr("blue (Fake B) did not answer" + within)) << mode;
    EXPECT_EQ(record.ticks, 5);
  }
  Options options_;
};

TEST_F(SlyTeams, WaitsForAChildThatSleeps) { expect_forfeit("vfork"); }

TEST_F(SlyTeams, WaitsForTheKernelAgainAndAgain) { expect_forfeit("barriers"); }

// Where others load the machine it waits for it, too, now and then: hence a short time for its reply.
TEST_F(SlyTeams, IsAwakeForAMomentAllTheTime) {
  options_.reply_deadline = 100ms;
  expect_forfeit("naps", " within 0.1 s");
}

TEST_F(SlyTeams, ComputesInChildrenThatNobodyWaitsFor) {
  const auto record = play(fakes::short_game("good", "reap"), options_);
  EXPECT_EQ(record.at_fault, Party::Blue) << record.reason;
  EXPECT_THAT(record.reason, HasSubstr("blue (Fake B) did not answer within 0.5 s"));
}

/// With others who compute all the time on the processor of the game and the next one.
class SlyTeamsOnABusyMachine : public SlyTeams {
 protected:
  SlyTeamsOnABusyMachine() {
    burn_on(options_.cpu);
    burn_on(options_.cpu == 0 ? 1 : options_.cpu - 1);
  }
  ~SlyTeamsOnABusyMachine() override {
    for (const pid_t other : others_) {
      ::kill(other, SIGKILL);
      ::waitpid(other, nullptr, 0);
    }
  }
  void burn_on(int processor) {
    const pid_t other = ::fork();
    if (other != 0) {
      others_.push_back(other);
      return;
    }
    ::alarm(120);  // for a test that fails
    cpu_set_t processors;
    CPU_ZERO(&processors);
    CPU_SET(static_cast<std::size_t>(processor), &processors);
    ::sched_setaffinity(0, sizeof processors, &processors);
    while (true) std::clock();
  }

 private:
  std::vector<pid_t> others_;
};

TEST_F(SlyTeamsOnABusyMachine, ComputesWithTheLowestPriority) { expect_forfeit("idle"); }

TEST_F(SlyTeamsOnABusyMachine, ComputesInASessionOfLowPriority) { expect_forfeit("modest-group"); }

TEST_F(SlyTeamsOnABusyMachine, GoesWhereOthersCompute) { expect_forfeit("naps-elsewhere"); }

// Not sly: one of eight that want the processor computes for its reply, and gets the time for it.
TEST_F(SlyTeamsOnABusyMachine, WhoComputesHonestlyIsNotBlamed) {
  for (int i = 0; i < 6; ++i) burn_on(options_.cpu);
  options_.last_tick = 8;
  auto config = fakes::short_game("good", "good");
  config.teams.blue.command = fakes::slow_team("think", 250, 7);
  const auto record = play(config, options_);
  EXPECT_NE(record.at_fault, Party::Blue) << record.reason;
}

}  // namespace
}  // namespace host
