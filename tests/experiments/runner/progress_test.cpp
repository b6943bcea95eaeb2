#include "experiments/runner/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "experiments/runner/plan.h"
#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

using testing::HasSubstr;

record::Attempt game(std::size_t index, int a_goals, int b_goals) {
  record::Attempt attempt = attempt_of({schedule::game(small_design(6), index), 1});
  attempt.record.termination = record::Termination::Finished;
  attempt.record.at_fault = record::Party::Nobody;
  attempt.record.goals[attempt.a_colour] = a_goals;
  attempt.record.goals[world::opponent(attempt.a_colour)] = b_goals;
  return attempt;
}

TEST(Progress, SaysGamesRateTimeLeftAndScoresOfA) {
  const schedule::Design design = small_design(6);
  std::ostringstream out;
  Progress progress(out, false, design, 24, 4);
  const auto later = Progress::Clock::now() + std::chrono::seconds(30);
  progress.left(TimeLeft::Estimate{170, 150, 190});
  progress.ended(game(0, 2, 1), 5, later);
  progress.ended(game(1, 0, 1), 6, later);
  progress.ended(game(2, 1, 1), 7, later);
  // Three games in 30 s: six a minute. The clock started a moment before `later` - 30 s.
  EXPECT_THAT(out.str(), HasSubstr("7/24 games, 6.0/min, 2:50 left (2:30-3:10) | equal 1-0-1, slow 0-1-0"));
  EXPECT_THAT(out.str(), HasSubstr("equal-0000-0: A 2:1 B"));
}

TEST(Progress, DrawsOverItsLineOnATerminalOnly) {
  const schedule::Design design = small_design(6);
  std::ostringstream terminal;
  Progress drawn(terminal, true, design, 24, 0);
  drawn.tick(2);
  EXPECT_THAT(terminal.str(), HasSubstr("\r\033[K0/24 games"));
  std::ostringstream file;
  Progress plain(file, false, design, 24, 0);
  plain.tick(2);
  EXPECT_EQ(file.str(), "");
}

TEST(Progress, TellsOfFaultsAtOnce) {
  const schedule::Design design = small_design(6);
  std::ostringstream out;
  Progress progress(out, true, design, 24, 0);
  record::Attempt crashed = game(0, 0, 0);
  crashed.record.termination = record::Termination::Crashed;
  crashed.record.at_fault = record::Party::Blue;
  crashed.record.reason = "blue ended with code 3";
  progress.ended(crashed, 1);
  EXPECT_THAT(out.str(), HasSubstr("equal-0000-0: forfeit, A at fault: blue ended with code 3"));
}

}  // namespace
}  // namespace runner
