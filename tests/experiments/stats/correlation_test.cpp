#include "experiments/stats/correlation.h"

#include <gtest/gtest.h>

#include <vector>

namespace stats {
namespace {

using Pairs = std::vector<std::array<double, 2>>;

// Anscombe's first data set (1973), as R's cor.test prints it.
TEST(PairCorrelation, GivesThePublishedValueOfAnscombesData) {
  const Pairs pairs = {{10, 8.04}, {8, 6.95}, {13, 7.58},  {9, 8.81}, {11, 8.33}, {14, 9.96},
                       {6, 7.24},  {4, 4.26}, {12, 10.84}, {7, 4.82}, {5, 5.68}};
  const PairCorrelation found = pair_correlation(pairs);
  EXPECT_NEAR(found.value, 0.8164205, 5e-8);
  EXPECT_NEAR(found.interval.low, 0.4243912, 5e-8);
  EXPECT_NEAR(found.interval.high, 0.9506933, 5e-8);
}

TEST(PairCorrelation, ChangesSignWithOneOfTheGames) {
  const PairCorrelation same = pair_correlation(Pairs{{1, 2}, {2, 1}, {3, 5}, {4, 3}});
  const PairCorrelation other = pair_correlation(Pairs{{1, -2}, {2, -1}, {3, -5}, {4, -3}});
  EXPECT_DOUBLE_EQ(same.value, -other.value);
  EXPECT_DOUBLE_EQ(same.interval.low, -other.interval.high);
}

TEST(PairCorrelation, IsUnknownOfTwoPairsOrWithoutSpread) {
  EXPECT_FALSE(pair_correlation(Pairs{{1, 2}, {3, 4}}).known);
  EXPECT_FALSE(pair_correlation(Pairs{{1, 2}, {1, 4}, {1, 7}}).known);
  EXPECT_EQ(pair_correlation(Pairs{{1, 2}, {1, 4}, {1, 7}}).interval.high, 1);
}

}  // namespace
}  // namespace stats
