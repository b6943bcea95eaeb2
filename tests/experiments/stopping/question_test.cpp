#include "experiments/stopping/question.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/stopping/examples.h"

namespace stopping {
namespace {

record::PairState pair_of(const record::Attempt& first, const record::Attempt& second) {
  record::PairState state;
  state.legs = {&first, &second};
  return state;
}

TEST(Questions, AreTheConditions) {
  const std::vector<Question> found = questions(three_conditions(1));
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[1].name, "second");
  ASSERT_EQ(found[1].terms.size(), 1U);
  EXPECT_EQ(found[1].terms[0].condition, 1U);
  EXPECT_EQ(found[1].terms[0].weight, 1);
}

TEST(Questions, APanelIsOneQuestionInWhichAsGamesCountForAAndBsAgainst) {
  const std::vector<Question> found = questions(panel(1));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "base");
  std::vector<double> weights;
  for (const Question::Term& term : found[0].terms) weights.push_back(term.weight);
  EXPECT_EQ(weights, (std::vector<double>{0.5, -0.5, 0.5, -0.5})) << "two opponents: the mean over them";
}

TEST(PairScore, IsAsMeanGoalDifferenceWhateverItsColour) {
  const record::Attempt first = finished("base", 0, 0, 3, 1);
  const record::Attempt second = finished("base", 0, 1, 1, 2);
  EXPECT_EQ(pair_score(pair_of(first, second), schedule::Metric::GoalDifference, 3), 0.5);
  EXPECT_EQ(pair_score(pair_of(first, second), schedule::Metric::Points, 3), 0.5);
  const record::Attempt draw = finished("base", 0, 1, 2, 2);
  EXPECT_EQ(pair_score(pair_of(first, draw), schedule::Metric::Points, 3), 0.75);
}

TEST(PairScore, CountsAForfeitAgainstTheTeamAtFault) {
  const record::Attempt first = finished("base", 0, 0, 0, 0);
  record::Attempt second = finished("base", 0, 1, 5, 0);  // A is yellow, leads, and falls over
  second.record.termination = record::Termination::Crashed;
  second.record.at_fault = record::Party::Yellow;
  EXPECT_EQ(pair_score(pair_of(first, second), schedule::Metric::GoalDifference, 4), -2);
  EXPECT_EQ(pair_score(pair_of(first, second), schedule::Metric::Points, 4), 0.25);
}

TEST(SequentialPlan, IsInPairsAndSharesAlpha) {
  schedule::Stopping rule;
  rule.rule = schedule::StopRule::Sequential;
  rule.h0 = -0.1;
  rule.h1 = 0.3;
  rule.clip = 4;
  const schedule::Design design = three_conditions(50, rule);
  const stats::SequentialPlan plan = sequential_plan(design, questions(design)[0], 3);
  // A pair's mean has the same mean as a game and, if games are independent, 1/sqrt(2) of its deviation.
  EXPECT_DOUBLE_EQ(plan.hypotheses.t0, -0.1 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(plan.hypotheses.t1, 0.3 * std::sqrt(2));
  EXPECT_DOUBLE_EQ(plan.alpha, 0.05 / 3);
  EXPECT_EQ(plan.beta, 0.05);
  EXPECT_EQ(plan.cap, 50);
  EXPECT_EQ(plan.clip, 4);
}

TEST(SequentialPlan, OfAPanelKnowsTheDeviationOfADifferenceOfMeans) {
  schedule::Stopping rule;
  rule.metric = schedule::Metric::Points;
  const schedule::Design design = panel(50, rule);
  const stats::SequentialPlan plan = sequential_plan(design, questions(design)[0], 1);
  // Per pair two means of 2 games times 2 opponents: variance 2 / 4 of a game's, so t is h sqrt(2).
  EXPECT_DOUBLE_EQ(plan.hypotheses.t1, 0.2 * std::sqrt(2));
  EXPECT_EQ(plan.metric, stats::Metric::GoalDifference) << "a difference of points is no share of points";
}

}  // namespace
}  // namespace stopping
