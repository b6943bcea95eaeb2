#include "experiments/host/budget.h"

#include <gtest/gtest.h>

namespace host {
namespace {

using namespace std::chrono_literals;

/// A team with 2 s for a simulated second and 10 s for a game, on a clock of our own.
class BudgetTest : public testing::Test {
 protected:
  BudgetTest() { budget_.begin({.second = 2s, .game = 10s}, now_, team_, host_delay_); }

  /// What happens in a tick, beside the team's own doing.
  struct Tick {
    std::chrono::milliseconds computes{};       ///< the team
    std::chrono::milliseconds sleeps{};         ///< the team
    std::chrono::milliseconds queues{};         ///< the team waits for a processor
    std::chrono::milliseconds host_queues{};    ///< the host waits for one when the answer has come
    std::chrono::milliseconds in_background{};  ///< the team computes after its answer
  };
  /// Sixty of them are a simulated second. Looks as the host does: after 10 ms of waiting, and at the end.
  void play(const Tick& tick, int ticks = 60) {
    for (int i = 0; i < ticks; ++i) {
      budget_.sent(now_);
      pass(tick.sleeps);
      pass(tick.queues, &team_.delay_seconds);
      pass(tick.computes, &team_.living_seconds);
      pass(tick.host_queues, &host_delay_);
      budget_.answered(now_);
      now_ += tick.in_background;
      team_.living_seconds += seconds(tick.in_background);
    }
    look();
    settle();
    budget_.begin_second(++second_, now_);
  }
  void pass(std::chrono::milliseconds span, double* counter = nullptr) {
    for (auto left = span; left > 0ms; left -= 10ms) {
      const auto step = std::min<std::chrono::milliseconds>(left, 10ms);
      now_ += step;
      if (counter != nullptr) *counter += seconds(step);
      if (step < 10ms) continue;
      budget_.count_wait(now_);
      look();
    }
  }
  void look() {
    if (!budget_.wants_look(now_)) return;
    ++looks_;
    settle();
  }
  void settle() {
    team_.processor_seconds = team_.living_seconds + ended_;
    budget_.look(now_, team_, host_delay_);
  }
  static double seconds(std::chrono::milliseconds span) {
    return std::chrono::duration<double>(span).count();
  }

  Budget::Clock::time_point now_{};
  TeamTime team_{.processor_seconds = 3, .living_seconds = 3, .delay_seconds = 1};
  double host_delay_ = 4;
  double ended_ = 0;  // [s] of threads that have ended
  std::int64_t second_ = 1;
  int looks_ = 0;
  Budget budget_;
};

TEST_F(BudgetTest, CountsSleepAndComputingOfEveryTickHoweverShort) {
  play({.sleeps = 1ms});  // never waited for long enough to be looked at
  EXPECT_NEAR(budget_.own_seconds(), 0.06, 1e-6);
  play({.computes = 3ms, .sleeps = 1ms});
  EXPECT_NEAR(budget_.own_seconds(), 0.3, 1e-6);
  EXPECT_EQ(budget_.excess(), "");
}

TEST_F(BudgetTest, SaysTheNumbersOfASecondThatTookTooLong) {
  play({.sleeps = 30ms});
  EXPECT_EQ(budget_.excess(), "");
  // 49 ms: 2 s are used up after 41 of 60 ticks, seen at one of the looks every 0.1 s.
  for (int i = 0; i < 60 && budget_.excess().empty(); ++i) {
    budget_.sent(now_);
    pass(49ms);
    budget_.answered(now_);
    look();
  }
  EXPECT_EQ(budget_.excess(), "used 2.05 s of its own time for simulated second 2, 2 s are allowed");
}

TEST_F(BudgetTest, ASecondHasItsOwnAllowance) {
  for (int second = 0; second < 5; ++second) {
    play({.sleeps = 30ms});
    EXPECT_EQ(budget_.excess(), "");
  }
  play({.sleeps = 30ms});  // 10.8 s
  EXPECT_EQ(budget_.excess().substr(0, 10), "used 10.8 ");
  EXPECT_EQ(budget_.excess().substr(10),
            "s of its own time for the game up to simulated second 7, 10 s are allowed");
}

// The machine: ten times as much time goes by as the team can use.
TEST_F(BudgetTest, DoesNotCountWhileTheTeamWaitsForAProcessor) {
  for (int second = 0; second < 20; ++second) play({.computes = 2ms, .sleeps = 1ms, .queues = 27ms});
  EXPECT_NEAR(budget_.own_seconds(), 20 * 60 * 0.003, 0.001);
  EXPECT_EQ(budget_.excess(), "");
}

TEST_F(BudgetTest, DoesNotCountWhileTheHostWaitsForAProcessor) {
  for (int second = 0; second < 20; ++second) play({.sleeps = 1ms, .host_queues = 15ms});
  EXPECT_NEAR(budget_.own_seconds(), 20 * 60 * 0.001, 0.001);
}

// A minute in which nothing ran: a suspended machine. 20 ms of it count.
TEST_F(BudgetTest, DoesNotCountWhileTheHostStandsStill) {
  budget_.sent(now_);
  now_ += 60s;
  budget_.answered(now_);
  look();
  EXPECT_NEAR(budget_.own_seconds(), 0.02, 1e-6);
}

// Between two looks that see it want a processor or the disk; after an answer that says nothing.
TEST_F(BudgetTest, DoesNotCountASleepInWhichSomeThreadWantsAProcessorOrTheDisk) {
  budget_.sent(now_);
  pass(20s, &team_.delay_seconds);
  EXPECT_NEAR(budget_.own_seconds(), 0, 1e-6);
  budget_.answered(now_);
  settle();
  play({.sleeps = 1ms});
  EXPECT_NEAR(budget_.own_seconds(), 0.06, 0.001);
}

TEST_F(BudgetTest, CountsWhatIsComputedBesides) {
  play({.in_background = 40ms});  // 2.4 s, while nobody waits for it
  EXPECT_NEAR(budget_.own_seconds(), 2.4, 1e-6);
}

// The other team was heard first: until then nobody knows whom we waited for.
TEST_F(BudgetTest, DoesNotCountTheOtherTeamsTime) {
  for (int i = 0; i < 60; ++i) {
    budget_.sent(now_);
    now_ += 9ms;
    budget_.wait_only_from(now_);
    now_ += 2ms;
    budget_.answered(now_);
  }
  look();
  EXPECT_NEAR(budget_.own_seconds(), 0.12, 1e-6);
}

// Threads that live for a tick take the knowledge of their delays with them: then only a look while it is
// waited for can tell a sleep from a delay.
TEST_F(BudgetTest, WithoutDelaysOnlyWhatIsSeenAsleepCounts) {
  team_.delays_known = false;
  play({.sleeps = 5ms}, 600);  // seen between ticks only
  EXPECT_EQ(budget_.own_seconds(), 0);
  play({.sleeps = 500ms}, 2);
  EXPECT_NEAR(budget_.own_seconds(), 1, 0.1) << "what is seen after the last answer is lost";
}

TEST_F(BudgetTest, ThreadsThatEndMakeDelaysUnknownButTheirProcessorTimeCounts) {
  for (int i = 0; i < 1000; ++i) {
    budget_.sent(now_);
    now_ += 5ms;
    budget_.answered(now_);
    ended_ += 0.002;
    look();
  }
  EXPECT_NEAR(budget_.own_seconds(), 2, 0.1) << "not 5; the first look or two take it for sleep";
}

// Nobody can tell its sleep from the machine's delays: half as much again as is allowed is its own.
TEST_F(BudgetTest, WithoutDelaysAWaitThatIsNotSeenAsSleepHasALimit) {
  team_.delays_known = false;
  team_.wants_machine = true;
  play({.sleeps = 40ms});  // 2.4 s
  EXPECT_EQ(budget_.own_seconds(), 0);
  EXPECT_EQ(budget_.excess(), "");
  play({.sleeps = 40ms, .queues = 50ms});  // the last are delays that are known
  EXPECT_EQ(budget_.excess(), "");
  for (int i = 0; i < 60 && budget_.excess().empty(); ++i) {
    budget_.sent(now_);
    pass(61ms);
    budget_.answered(now_);
    look();
  }
  EXPECT_EQ(budget_.excess().substr(0, 16), "was waited for 3") << "and a little more";
  EXPECT_EQ(budget_.excess().substr(budget_.excess().find(" s for")),
            " s for simulated second 3, with threads or children that end all the time, so that its own time "
            "cannot be told from the machine's, 2 s are allowed");
}

TEST_F(BudgetTest, ProcessorTimeOfChildrenThatNobodyWaitedForCounts) {
  for (int i = 0; i < 10; ++i) {
    budget_.sent(now_);
    pass(100ms);
    budget_.answered(now_);
    team_.wants_machine = true;
    team_.used_seconds += 0.09;
    team_.living_seconds -= 0.001;
    look();
  }
  EXPECT_NEAR(budget_.own_seconds(), 0.9, 0.1);
}

TEST_F(BudgetTest, LooksTwentyTimesInABudgetAndOnceASecondAtLeast) {
  play({.computes = 1ms, .in_background = 10ms}, 100);
  EXPECT_EQ(looks_, 1) << "only at the end, since nobody was waited for";
  pass(2000ms);
  EXPECT_EQ(looks_, 21);
  Budget usual;
  usual.begin({.second = 20s, .game = 1440s}, now_, team_, 0);
  EXPECT_FALSE(usual.wants_look(now_ + 999ms));
  EXPECT_TRUE(usual.wants_look(now_ + 1s));
}

TEST_F(BudgetTest, NothingIsLookedAtWithoutABeginning) {
  const Budget none;
  EXPECT_FALSE(none.wants_look(now_ + 1h));
  EXPECT_EQ(none.excess(), "");
}

TEST_F(BudgetTest, NoughtIsAnyAmount) {
  budget_.begin({}, now_, team_, host_delay_);
  play({.sleeps = 2000ms});
  EXPECT_GT(budget_.own_seconds(), 119);
  EXPECT_EQ(budget_.excess(), "");
}

}  // namespace
}  // namespace host
