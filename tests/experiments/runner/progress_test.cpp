#include "experiments/runner/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "experiments/runner/plan.h"
#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

using testing::HasSubstr;

record::Attempt game(std::size_t index, int a_goals, int b_goals, int number = 1) {
  record::Attempt attempt = attempt_of({schedule::game(small_design(6), index), number});
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
  EXPECT_THAT(out.str(), HasSubstr("7/24 games, 6.0/min, 2:50 left (2:30-3:10) | equal 1-0-1, slow 0-0-0"))
      << "the other game of the pair of slow is not there yet";
  EXPECT_THAT(out.str(), HasSubstr("equal-0000-0: A 2:1 B"));
}

record::Attempt void_game(std::size_t index, int number) {
  record::Attempt attempt = game(index, 0, 0, number);
  attempt.record.termination = record::Termination::Crashed;
  attempt.record.at_fault = record::Party::Harness;
  attempt.record.reason = "the worker ended";
  return attempt;
}

TEST(Progress, AGameOfAVoidPairIsNotInTheScore) {
  const schedule::Design design = small_design(6);
  std::ostringstream out;
  Progress progress(out, false, design, 24, 0);
  const auto score = [&] {
    const std::string line = progress.line(Progress::Clock::now());
    return line.substr(line.find("| "));
  };
  progress.ended(game(0, 5, 0), 1);
  progress.ended(void_game(1, 1), 0);
  EXPECT_EQ(score(), "| equal 0-0-0, slow 0-0-0");
  progress.ended(game(0, 0, 2, 2), 1);
  progress.ended(game(1, 0, 0, 2), 2);
  EXPECT_EQ(score(), "| equal 0-1-1, slow 0-0-0") << "of the second attempt alone";
  // Leg 0 of a second attempt is known before the void leg 1 of the first: the order of a ledger.
  progress.known(game(4, 1, 0));
  progress.known(game(4, 0, 1, 2));
  progress.known(void_game(5, 1));
  progress.known(game(5, 0, 1, 2));
  EXPECT_EQ(score(), "| equal 0-1-3, slow 0-0-0");
}

TEST(Progress, AGivenUpPairIsNotInTheScore) {
  const schedule::Design design = small_design(6);
  std::ostringstream out;
  Progress progress(out, false, design, 24, 0);
  for (int number = 1; number <= record::max_attempts; ++number) {
    progress.known(game(0, 1, 0, number));
    progress.known(void_game(1, number));
  }
  EXPECT_THAT(progress.line(Progress::Clock::now()), HasSubstr("equal 0-0-0"));
}

TEST(Progress, PairsBehindTheEndOfATestAreNotInTheScore) {
  const schedule::Design design = small_design(6);
  std::ostringstream out;
  Progress progress(out, false, design, 24, 0);
  for (const std::size_t index : {0U, 1U, 4U, 5U, 8U}) progress.known(game(index, 1, 0));
  progress.stop("equal", 1);
  EXPECT_THAT(progress.line(Progress::Clock::now()), HasSubstr("equal 2-0-0"));
  progress.ended(game(9, 1, 0), 5);
  EXPECT_THAT(progress.line(Progress::Clock::now()), HasSubstr("equal 2-0-0"))
      << "it was running when the test ended";
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
