#include "experiments/host/team_time.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace host {
namespace {

using namespace std::chrono_literals;

/// A team that is looked at every 0.1 s, and may wait 2 s for the disk.
class TeamClockTest : public testing::Test {
 protected:
  TeamClockTest() { look(); }
  void look() {
    now_ += 100ms;
    process::Activity activity;
    activity.threads = threads_;
    activity.processor_seconds = processor_;
    time_ = clock_.read(now_, activity);
  }
  /// So many looks, with the same happening to a thread before each.
  template <class What>
  void looks(int count, What what) {
    for (int i = 0; i < count; ++i) {
      what();
      look();
    }
  }
  process::Thread& thread() { return threads_.front(); }

  std::vector<process::Thread> threads_ = std::vector<process::Thread>(1);
  double processor_ = 100;  // [s] of all processes, also of threads that have ended
  TeamClock::Clock::time_point now_{};
  TeamClock clock_{2s};
  TeamTime time_;
};

TEST_F(TeamClockTest, WhoSleepsOrComputesIsOwedNothing) {
  looks(100, [] {});
  thread().wants_processor = true;  // it runs
  looks(100, [&] { thread().on_seconds += 0.1; });
  EXPECT_EQ(time_.delay_seconds, 0);
}

TEST_F(TeamClockTest, DelaysAreOwedWhenTheKernelTellsThem) {
  looks(10, [&] { thread().delay_seconds += 0.09; });
  EXPECT_NEAR(time_.delay_seconds, 0.9, 1e-9);
}

// Five seconds without a turn: seen from the second look on, and not once more when the kernel tells them.
TEST_F(TeamClockTest, AWaitThatIsNotOverIsOwed) {
  thread().wants_processor = true;
  look();
  EXPECT_EQ(time_.delay_seconds, 0) << "it may have begun just now";
  EXPECT_TRUE(time_.wants_machine);
  looks(50, [] {});
  EXPECT_NEAR(time_.delay_seconds, 5, 1e-9);
  thread() = {.on_seconds = 0.001, .delay_seconds = 5.05};
  look();
  EXPECT_NEAR(time_.delay_seconds, 5.05, 1e-9);
  EXPECT_FALSE(time_.wants_machine);
}

// Turns of 3 ms every 150 ms: a look between two of them cannot know of the wait that it is in.
TEST_F(TeamClockTest, WaitsLongerThanALookAreOwedAsAWhole) {
  thread().wants_processor = true;
  for (int turn = 0; turn < 20; ++turn) {
    looks(1, [&] {
      thread().on_seconds += 0.003;
      thread().delay_seconds += turn % 2 == 0 ? 0.147 : 0;
    });
  }
  EXPECT_NEAR(time_.delay_seconds, 1.47, 1e-9);
}

// Naps of 0.1 ms: at every look it runs, or has just been woken.
TEST_F(TeamClockTest, WhoIsSeenAwakeButHasItsTurnsIsOwedNoSleep) {
  thread().wants_processor = true;
  looks(100, [&] {
    thread().on_seconds += 0.005;
    thread().delay_seconds += 0.001;
  });
  EXPECT_NEAR(time_.delay_seconds, 0.1, 1e-9);
  EXPECT_FALSE(time_.wants_machine);
}

TEST_F(TeamClockTest, WhoHasChosenToWaitIsOwedNothing) {
  thread() = {.wants_processor = true, .by_choice = true};
  looks(50, [&] { thread().delay_seconds += 0.1; });
  EXPECT_EQ(time_.delay_seconds, 0);
  EXPECT_FALSE(time_.wants_machine);
}

TEST_F(TeamClockTest, UninterruptibleWaitsAreOwedUpToALimit) {
  thread().uninterruptible = true;
  looks(10, [] {});
  EXPECT_NEAR(time_.delay_seconds, 1, 1e-9);
  looks(100, [] {});
  EXPECT_NEAR(time_.delay_seconds, 2, 1e-9);
}

// The kernel's sums do not have them when they have ended.
TEST_F(TeamClockTest, WhatChildrenUseThatNobodyWaitsForIsAddedUp) {
  looks(20, [&] {
    ++thread().id;
    thread().on_seconds = 0.03;
  });
  EXPECT_NEAR(time_.used_seconds, 0.6, 1e-9);
  thread().by_choice = true;
  looks(10, [&] { thread().on_seconds += 0.1; });
  EXPECT_NEAR(time_.used_seconds, 1.6, 1e-9) << "whatever its priority";
}

TEST_F(TeamClockTest, WhatThreadsUsedThatHaveEndedCountsOnce) {
  looks(10, [&] {
    thread().on_seconds += 0.06;
    processor_ += 0.1;
  });
  EXPECT_NEAR(time_.used_seconds, 0.8, 1e-9) << "0.02 s a look may be rounding";
  looks(10, [&] {
    thread().on_seconds += 0.1;
    processor_ += 0.1;
  });
  EXPECT_NEAR(time_.used_seconds, 1.8, 1e-9);
}

// A look once a second of a game that is played, or none for a minute.
TEST_F(TeamClockTest, AWaitForTheDiskBetweenLooksFarApartIsASecondAtMost) {
  thread().uninterruptible = true;
  now_ += 60s;
  look();
  EXPECT_NEAR(time_.delay_seconds, 1, 1e-9);
}

// A chain of two adds up; eight that wait side by side are owed no more than the clock; of a hundred that get
// in each other's way only the longest delays count.
TEST_F(TeamClockTest, DelaysOfThreadsInTurnAddUp) {
  threads_ = std::vector<process::Thread>(100);
  for (int i = 0; i < 100; ++i) threads_[static_cast<std::size_t>(i)].id = i;
  look();
  const auto delay = [&](std::size_t count, double seconds) {
    const double before = time_.delay_seconds;
    for (std::size_t i = 0; i < count; ++i) threads_[i].delay_seconds += seconds;
    look();
    return time_.delay_seconds - before;
  };
  EXPECT_NEAR(delay(2, 0.03), 0.06, 1e-9);
  EXPECT_NEAR(delay(8, 0.08), 0.1, 1e-9);
  EXPECT_NEAR(delay(100, 0.005), 0.02, 1e-9);
}

TEST_F(TeamClockTest, ThreadsThatCameSinceTheLastLookAreOwedNothing) {
  looks(20, [&] {
    ++thread().id;
    thread().wants_processor = true;
    thread().delay_seconds = 0.05;
  });
  EXPECT_EQ(time_.delay_seconds, 0);
  EXPECT_TRUE(time_.wants_machine) << "perhaps it does";
}

// Without CONFIG_SCHED_INFO all times of threads are 0.
TEST_F(TeamClockTest, WithoutTimesOfThreadsWhoIsSeenAwakeTwiceIsOwedTheClock) {
  thread().wants_processor = true;
  looks(11, [] {});
  EXPECT_NEAR(time_.delay_seconds, 1, 1e-9);
}

}  // namespace
}  // namespace host
