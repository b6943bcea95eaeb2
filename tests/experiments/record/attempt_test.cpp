#include "experiments/record/attempt.h"

#include <gtest/gtest.h>

#include "tests/experiments/record/examples.h"

namespace record {
namespace {

PairState state_of(const std::vector<Attempt>& attempts) {
  std::vector<const Attempt*> pointers;
  for (const Attempt& attempt : attempts) pointers.push_back(&attempt);
  PairState state = pair_state(pointers);
  for (const Attempt*& leg : state.legs) {
    // The vector dies with the caller's expression: keep only whether there was one.
    static const Attempt present;
    if (leg != nullptr) leg = &present;
  }
  return state;
}

TEST(GameId, NamesConditionPairAndLeg) {
  EXPECT_EQ(game_id({"half-speed", 3, 1}), "half-speed-0003-1");
  EXPECT_EQ(game_id({"x", 12345, 0}), "x-12345-0");
}

TEST(PairState, BeginsWithTheFirstAttempt) {
  const PairState state = state_of({});
  EXPECT_EQ(state.attempt, 1);
  EXPECT_FALSE(state.complete());
  EXPECT_FALSE(state.given_up);
}

TEST(PairState, IsCompleteWithBothLegs) {
  EXPECT_FALSE(state_of({example_attempt(0, 1)}).complete());
  EXPECT_TRUE(state_of({example_attempt(0, 1), example_attempt(0, 0)}).complete());
}

TEST(PairState, OfAVoidGameStartsAgainWithBothLegs) {
  const PairState state = state_of({example_attempt(0, 0), void_attempt(0, 1, 1)});
  EXPECT_EQ(state.attempt, 2);
  EXPECT_EQ(state.legs[0], nullptr);
  EXPECT_EQ(state.voids, 1);
}

TEST(PairState, CountsTheLastAttemptOnly) {
  const PairState state = state_of(
      {example_attempt(0, 0), void_attempt(0, 1, 1), example_attempt(0, 0, 2), example_attempt(0, 1, 2)});
  EXPECT_TRUE(state.complete());
  EXPECT_EQ(state.attempt, 2);
}

TEST(PairState, IsGivenUpAfterThreeVoidAttempts) {
  const PairState state = state_of({void_attempt(0, 0, 1), void_attempt(0, 1, 2), void_attempt(0, 0, 3)});
  EXPECT_TRUE(state.given_up);
  EXPECT_FALSE(state.complete());
  EXPECT_EQ(state.voids, 3);
}

}  // namespace
}  // namespace record
