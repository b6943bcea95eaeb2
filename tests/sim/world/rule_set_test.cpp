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

}  // namespace
}  // namespace world
