#include "experiments/stopping/wording.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/stopping/examples.h"

namespace stopping {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

schedule::Stopping rule_of(schedule::StopRule kind) {
  schedule::Stopping rule;
  rule.rule = kind;
  return rule;
}

/// Every game of the design ends a : b, the second legs with one goal less for A.
std::vector<record::Attempt> all_games(const schedule::Design& design, int a, int b) {
  std::vector<record::Attempt> attempts;
  for (std::size_t i = 0; i < schedule::game_count(design); ++i) {
    const record::GameKey key = schedule::game(design, i).key;
    attempts.push_back(finished(key.condition, key.pair, key.leg, a - (key.pair % 2), b));
  }
  return attempts;
}

TEST(Sentence, NamesWhoAgainstWhomTheMetricTheDecisionAndThatTheEstimateIsCorrected) {
  const schedule::Design design = one_condition(40, rule_of(schedule::StopRule::Sequential));
  const std::vector<std::string> texts = sentences(design, all_games(design, 4, 1));
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], AllOf(StartsWith("base: A (new) against B (old), goal difference: H1 accepted"),
                              HasSubstr("after 12 pairs; estimate corrected for the stopping +"),
                              HasSubstr("goals a game (plain mean +2.50)")));
  EXPECT_THAT(sentences(design, all_games(design, 1, 4))[0],
              HasSubstr("H0 accepted, A is not better by more than 0"));
  EXPECT_THAT(sentences(design, {})[0], HasSubstr("not decided yet after 0 pairs"));
}

TEST(Sentence, SaysSharesOfPoints) {
  schedule::Stopping rule = rule_of(schedule::StopRule::Sequential);
  rule.metric = schedule::Metric::Points;
  const schedule::Design design = one_condition(40, rule);
  EXPECT_THAT(sentences(design, all_games(design, 2, 1))[0],
              AllOf(HasSubstr("points: H1 accepted"), HasSubstr("% of the points (plain mean 75.0)")));
}

TEST(Sentence, OfAPanelSaysThatBothMeetIt) {
  const schedule::Design design = panel(40, rule_of(schedule::StopRule::Sequential));
  EXPECT_THAT(sentences(design, all_games(design, 2, 1))[0],
              StartsWith("base: A (new) compared with B (old) against the panel, goal difference: "));
}

TEST(Sentence, OfPrecisionSaysTheErrorReached) {
  schedule::Stopping rule = rule_of(schedule::StopRule::Precision);
  rule.standard_error = 0.2;
  const schedule::Design design = one_condition(40, rule);
  EXPECT_THAT(sentences(design, all_games(design, 2, 1))[0],
              HasSubstr("reached the wanted 0.2 after 8 pairs; +0.50 ± 0.19"));
}

TEST(Sentence, IsNotNeededForAFixedNumber) {
  const schedule::Design design = one_condition(2);
  EXPECT_TRUE(sentences(design, all_games(design, 2, 1)).empty());
  EXPECT_EQ(rule(design), "fixed number: 2 pairs per condition");
}

TEST(Rule, SaysAllThatWasDecidedBeforehand) {
  EXPECT_EQ(
      rule(three_conditions(90, rule_of(schedule::StopRule::Sequential))),
      "sequential test of A's goal difference: H0 0 against H1 0.2 standard deviations of a game, alpha 0.05 "
      "shared by 3 questions, beta 0.05; looked at after 8 pairs and then every 4, at most 90");
}

}  // namespace
}  // namespace stopping
