#include "experiments/schedule/nearest.h"

#include <gtest/gtest.h>

namespace schedule {
namespace {

const std::vector<std::string> names = {"seed", "pairs", "speed_factor"};

TEST(DidYouMean, FindsAWordWithALetterChangedMissingAddedOrSwapped) {
  for (const char* word : {"speed_facter", "speed_factr", "speed_facttor", "sped_fatcor", "speed-factor"}) {
    EXPECT_EQ(did_you_mean(word, names), "; did you mean speed_factor?") << word;
  }
  EXPECT_EQ(did_you_mean("pears", names), "; did you mean pairs?");
  EXPECT_EQ(did_you_mean("esed", names), "; did you mean seed?");
}

TEST(DidYouMean, KnowsTheFirstOfSeveralWords) {
  const std::vector<std::string> of_a_team = {"name", "robots", "speed_factor"};
  EXPECT_EQ(did_you_mean("speed", of_a_team), "; did you mean speed_factor?");
  EXPECT_EQ(did_you_mean("sped", of_a_team), "; did you mean speed_factor?");
  EXPECT_EQ(did_you_mean("robust", names), "");
}

TEST(DidYouMean, SaysNothingAboutNoise) {
  EXPECT_EQ(did_you_mean("colour", names), "");
  EXPECT_EQ(did_you_mean("", names), "");
  EXPECT_EQ(did_you_mean("seed", {}), "");
}

}  // namespace
}  // namespace schedule
