#include "experiments/record/match_record.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace record {
namespace {

MatchRecord ended(int yellow, int blue, Termination termination, Party at_fault) {
  MatchRecord record;
  record.goals = {.yellow = yellow, .blue = blue};
  record.termination = termination;
  record.at_fault = at_fault;
  return record;
}

TEST(MatchRecord, IsWonByGoalsWhenFinished) {
  EXPECT_EQ(outcome(ended(2, 1, Termination::Finished, Party::Nobody)), Outcome::YellowWins);
  EXPECT_EQ(outcome(ended(0, 1, Termination::Finished, Party::Nobody)), Outcome::BlueWins);
  EXPECT_EQ(outcome(ended(1, 1, Termination::Finished, Party::Nobody)), Outcome::Draw);
}

TEST(MatchRecord, IsLostByTheTeamAtFaultWhateverTheScore) {
  const MatchRecord record = ended(5, 0, Termination::Crashed, Party::Yellow);
  EXPECT_EQ(outcome(record), Outcome::BlueWins);
  EXPECT_EQ(counted_goals(record, 3), (world::PerTeam<int>{.yellow = 0, .blue = 3}));
  EXPECT_EQ(counted_goals(ended(0, 5, Termination::NotConnected, Party::Blue), 4),
            (world::PerTeam<int>{.yellow = 4, .blue = 0}));
}

TEST(MatchRecord, IsVoidWhenBothOrTheHarnessAreAtFault) {
  EXPECT_EQ(outcome(ended(1, 0, Termination::NotResponding, Party::Both)), Outcome::Void);
  EXPECT_EQ(outcome(ended(1, 0, Termination::HarnessFault, Party::Harness)), Outcome::Void);
  EXPECT_EQ(outcome(MatchRecord{}), Outcome::Void);
}

TEST(MatchRecord, CountsGoalsAsPlayedWhenNobodyIsAtFault) {
  EXPECT_EQ(counted_goals(ended(2, 1, Termination::Finished, Party::Nobody), 3),
            (world::PerTeam<int>{.yellow = 2, .blue = 1}));
}

TEST(MatchRecord, NamesAreReadBack) {
  for (int i = 0; i <= static_cast<int>(Termination::StoodStill); ++i) {
    const auto termination = static_cast<Termination>(i);
    EXPECT_EQ(termination_from_name(name(termination)), termination);
  }
  for (int i = 0; i <= static_cast<int>(Party::Harness); ++i) {
    EXPECT_EQ(party_from_name(name(static_cast<Party>(i))), static_cast<Party>(i));
  }
  for (int i = 0; i <= static_cast<int>(Outcome::Void); ++i) {
    EXPECT_EQ(outcome_from_name(name(static_cast<Outcome>(i))), static_cast<Outcome>(i));
  }
  EXPECT_THROW(termination_from_name("ended"), std::invalid_argument);
}

}  // namespace
}  // namespace record
