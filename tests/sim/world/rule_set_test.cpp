#include "sim/world/rules/rule_set.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace world {
namespace {

TEST(RuleSet, EachNameFindsTheSetOfThatName) {
  ASSERT_FALSE(rule_set_names().empty());
  for (const std::string_view name : rule_set_names()) EXPECT_EQ(rule_set(name).name, name);
}

TEST(RuleSet, AnUnknownNameIsRefusedWithTheKnownOnes) {
  try {
    rule_set("ssl-1999");
    FAIL() << "no exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("'ssl-1999'"));
    EXPECT_THAT(error.what(), testing::HasSubstr("ssl-2015, paper"));
  }
}

// Table 18 and Algorithm 2 as printed, against the laws (requirements I-3, I-20).
TEST(RuleSet, ThePaperDiffersFromTheLawsWhereItIsPrintedOtherwise) {
  EXPECT_TRUE(rule_set("ssl-2015").retake_keeps_call);
  EXPECT_FALSE(rule_set("paper").retake_keeps_call);
  EXPECT_TRUE(rule_set("ssl-2015").direct_from_goal_line);
  EXPECT_FALSE(rule_set("paper").direct_from_goal_line);
}

// The paper's ten events (6.4), of which two are guards in the automaton; its Table 11 has the double touch.
TEST(RuleSet, ThePaperRunsItsTenEventsOnly) {
  const RuleSet& paper = rule_set("paper");
  EXPECT_THAT(paper.detectors, testing::UnorderedElementsAre("ball touched", "double touch", "ball too fast",
                                                             "dribbled too far", "goal", "ball left field",
                                                             "no progress", "kick taken", "robots settled"));
  EXPECT_FALSE(runs(paper, "collision"));
  EXPECT_TRUE(runs(rule_set("ssl-2015"), "collision"));
  EXPECT_FALSE(paper.chip_model);
  EXPECT_TRUE(paper.touch.accel && paper.touch.line && paper.touch.backtrack);
  EXPECT_FALSE(paper.touch.reach);
  EXPECT_EQ(paper.exit_frames, 3);
  EXPECT_EQ(paper.exit_frames_mouth, 3);
  EXPECT_EQ(paper.exit_frames_jump, 3);
  EXPECT_EQ(paper.exit_frames_hidden, 0);
}

// R-R15-16 and the larger field of today.
TEST(RuleSet, EachCanBePlayedOnOtherFields) {
  EXPECT_EQ(rule_set("ssl-2015").field.length, 9.0);
  EXPECT_EQ(rule_set("ssl-2015-field-2014").field.length, 8.09);
  EXPECT_EQ(rule_set("ssl-2015-field-2014").field.width, 6.05);
  EXPECT_EQ(rule_set("paper-division-a").field.length, 12.0);
  EXPECT_EQ(rule_set("paper-division-a").field.width, 9.0);
  EXPECT_EQ(rule_set("paper-division-a").detectors, rule_set("paper").detectors);
}

}  // namespace
}  // namespace world
