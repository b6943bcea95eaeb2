#include "experiments/host/patience.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace host {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A team with 5 s, looked at every 10 ms of a clock of our own.
class PatienceTest : public testing::Test {
 protected:
  PatienceTest() { patience_.begin(5s, now_); }

  /// Looks on for so long; `share` of it the team has a processor, and it wants one unless it sleeps.
  void pass(std::chrono::milliseconds span, double share, bool wants) {
    for (const auto end = now_ + span; now_ < end && !patience_.is_over();) {
      now_ += 10ms;
      processor_ += 0.01 * share;
      if (wants) delay_ += 0.01 * std::max(0.0, 1 - share);
      patience_.count(now_, [&] {
        ++looks_;
        return TeamTime{.processor_seconds = processor_, .delay_seconds = delay_};
      });
    }
  }
  std::chrono::milliseconds passed() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(now_ - begin_);
  }

  Patience::Clock::time_point begin_{};
  Patience::Clock::time_point now_ = begin_;
  double processor_ = 3;  // [s] of the game before
  double delay_ = 2;      // [s] of the game before
  int looks_ = 0;
  Patience patience_;
};

TEST_F(PatienceTest, CountsTheClockWhileTheTeamSleeps) {
  pass(60s, 0, false);
  EXPECT_EQ(passed(), 5000ms);
  EXPECT_EQ(patience_.within(), " within 5 s");
}

TEST_F(PatienceTest, CountsTheClockWhileTheTeamHasAProcessor) {
  pass(60s, 1, true);
  EXPECT_EQ(passed(), 5000ms);
}

// A tenth of a processor: 0.1 s before anything is known of it, then 4.9 s of its own time take 49 s, but
// after 30 s it is the machine's fault.
TEST_F(PatienceTest, DoesNotBlameATeamThatWaitsForAProcessor) {
  pass(20s, 0.1, true);
  EXPECT_FALSE(patience_.is_over());
  EXPECT_FALSE(patience_.machine_is_too_slow());
  pass(10s, 0.1, true);
  EXPECT_FALSE(patience_.is_over());
  EXPECT_TRUE(patience_.machine_is_too_slow());
  EXPECT_EQ(patience_.starved(), "in 30 s it could use only 3.09 s");  // 0.1 + 29.9 / 10
}

// Half a processor: 0.1 + 9.8 s.
TEST_F(PatienceTest, SaysHowLongItWasOnTheClockWhenThatWasMuchMore) {
  pass(60s, 0.5, true);
  EXPECT_EQ(passed(), 9900ms);
  EXPECT_THAT(patience_.within(), HasSubstr(" within 5 s of its own time, 9.9 s by the clock"));
}

// A minute between two looks: a suspended machine, or a host that had no processor itself. 0.2 s of it count.
TEST_F(PatienceTest, DoesNotCountWhileTheHostStandsStill) {
  pass(1s, 0, false);
  now_ += 60s;
  pass(3700ms, 0, false);
  EXPECT_FALSE(patience_.is_over());
  pass(200ms, 0, false);
  EXPECT_TRUE(patience_.is_over());
}

// Several threads use more than one processor; their time is still that of the clock.
TEST_F(PatienceTest, CountsNothingTwice) {
  pass(60s, 4, true);
  EXPECT_EQ(passed(), 5000ms);
}

TEST_F(PatienceTest, LooksAtProcessesNoMoreThanTenTimesASecondAndNeverAfterTheEnd) {
  pass(90ms, 0, false);
  EXPECT_EQ(looks_, 0) << "who answers soon costs nothing";
  pass(910ms, 0, false);
  EXPECT_EQ(looks_, 10);
  patience_.end();
  pass(60s, 0, false);
  EXPECT_EQ(looks_, 10);
}

TEST_F(PatienceTest, BeginsAnew) {
  pass(4s, 1, true);
  patience_.begin(1s, now_);
  pass(60s, 0, false);
  EXPECT_EQ(passed(), 5000ms);
}

}  // namespace
}  // namespace host
