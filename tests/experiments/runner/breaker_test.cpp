#include "experiments/runner/breaker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/record/waited_for.h"

namespace runner {
namespace {

using testing::HasSubstr;

enum class How { Good, Void, AForfeits, BForfeits };

record::Attempt attempt(How how) {
  record::Attempt attempt;
  attempt.a_colour = world::Team::Blue;
  attempt.record.termination = record::Termination::Crashed;
  attempt.record.reason = "it fell over";
  attempt.record.at_fault = how == How::Void        ? record::Party::Harness
                            : how == How::AForfeits ? record::Party::Blue
                                                    : record::Party::Yellow;
  if (how == How::Good) {
    attempt.record.termination = record::Termination::Finished;
    attempt.record.at_fault = record::Party::Nobody;
  }
  return attempt;
}

void add(Breaker& breaker, How how, int times) {
  for (int i = 0; i < times; ++i) breaker.add(attempt(how));
}

schedule::Limits limits(int in_a_row, double share) {
  schedule::Limits limits;
  limits.faults_in_a_row = in_a_row;
  limits.fault_share = share;
  return limits;
}

TEST(Breaker, TripsAfterSoManyVoidGamesInARow) {
  Breaker breaker(limits(3, 1), 1000);
  add(breaker, How::Void, 2);
  add(breaker, How::Good, 1);
  add(breaker, How::Void, 2);
  EXPECT_FALSE(breaker.tripped());
  add(breaker, How::Void, 1);
  EXPECT_THAT(*breaker.tripped(), HasSubstr("3 games in a row were void (the last: it fell over)"));
}

TEST(Breaker, SaysForWhichTeamTheHostWaitedInVoidGames) {
  Breaker breaker(limits(100, 1), 1000);
  add(breaker, How::Void, 4);
  EXPECT_EQ(breaker.waits(), "");
  record::Attempt waited = attempt(How::Void);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(breaker.waits(), "");
    waited.a_colour = i == 1 ? world::Team::Yellow : world::Team::Blue;
    waited.record.costs = {{record::waited_for(world::opponent(waited.a_colour)), 1}};
    breaker.add(waited);
  }
  EXPECT_EQ(breaker.waits(), "in 3 of 7 void games the host waited for team B");
  for (int i = 0; i < 3; ++i) {
    waited.record.costs = {{record::waited_for(waited.a_colour), 1}};
    breaker.add(waited);
  }
  EXPECT_EQ(breaker.waits(), "in 3 of 10 void games the host waited for each team");
}

TEST(Breaker, TripsAboveAShareButNotBeforeTwentyGames) {
  Breaker breaker(limits(100, 0.1), 1000);
  for (int i = 0; i < 9; ++i) {
    add(breaker, How::Void, 1);
    add(breaker, How::Good, 1);
  }
  EXPECT_FALSE(breaker.tripped()) << "half of 18";
  add(breaker, How::Good, 1);
  EXPECT_FALSE(breaker.tripped());
  add(breaker, How::Good, 1);
  EXPECT_THAT(*breaker.tripped(), HasSubstr("9 of 20 games were void, at most 10 % may be"));
}

TEST(Breaker, TheShareItselfIsAllowed) {
  Breaker breaker(limits(100, 0.1), 1000);
  add(breaker, How::Good, 18);
  add(breaker, How::Void, 2);
  EXPECT_FALSE(breaker.tripped());
}

TEST(Breaker, TripsWhenTheRetryBudgetIsUsedUp) {
  Breaker breaker(limits(5, 1), 200);  // a tenth: 20 games
  for (int i = 0; i < 20; ++i) {
    add(breaker, How::Void, 1);
    add(breaker, How::Good, 1);
  }
  EXPECT_FALSE(breaker.tripped());
  add(breaker, How::Void, 1);
  EXPECT_THAT(*breaker.tripped(), HasSubstr("21 games were void, 20 are played again"));
}

TEST(Breaker, TripsWhenOneTeamOnlyForfeits) {
  Breaker breaker(limits(5, 0.1), 1000);
  add(breaker, How::AForfeits, Breaker::forfeits_in_a_row - 1);
  add(breaker, How::BForfeits, 1);
  EXPECT_FALSE(breaker.tripped());
  add(breaker, How::BForfeits, Breaker::forfeits_in_a_row - 1);
  EXPECT_THAT(*breaker.tripped(), HasSubstr("team B forfeited 30 games in a row"));
}

}  // namespace
}  // namespace runner
