#include "experiments/stats/elo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace stats {
namespace {

TEST(Elo, GivesTheFamiliarValues) {
  EXPECT_NEAR(elo(0.75), 190.85, 0.005);
  EXPECT_NEAR(elo(10.0 / 11), 400, 1e-9);
  EXPECT_EQ(elo(0.5), 0);
  EXPECT_TRUE(std::isinf(elo(1)));
  EXPECT_LT(elo(0), 0);
}

TEST(Elo, IsTheInverseOfTheExpectedScore) { EXPECT_NEAR(expected_score(elo(0.63)), 0.63, 1e-12); }

TEST(EloOf, TransformsTheEndsOfTheInterval) {
  const Mean mean = mean_of(std::vector<double>{1, 0.5, 0.5, 1, 0, 0.5, 1, 0.5});
  const EloEstimate estimate = elo_of(mean);
  EXPECT_NEAR(expected_score(estimate.interval.high) - mean.mean, 1.959964 * mean.standard_error, 1e-6);
  EXPECT_TRUE(std::isinf(elo_of(mean_of(std::vector<double>{1, 1})).value));
}

TEST(LikelihoodOfSuperiority, IsAHalfWhenNothingIsKnown) {
  EXPECT_EQ(likelihood_of_superiority({}), 0.5);
  EXPECT_EQ(likelihood_of_superiority(mean_of(std::vector<double>{0.5, 0.5})), 0.5);
  EXPECT_EQ(likelihood_of_superiority(mean_of(std::vector<double>{1, 1})), 1);
}

TEST(LikelihoodOfSuperiority, IsTheNormalTail) {
  Mean mean;
  mean.count = 100;
  mean.mean = 0.6;
  mean.standard_error = 0.1 / 1.6448536;
  EXPECT_NEAR(likelihood_of_superiority(mean), 0.95, 1e-6);
}

TEST(NormalisedElo, IsThreeHundredFortySevenPerUnit) { EXPECT_NEAR(normalised_elo(1), 347.4356, 5e-5); }

}  // namespace
}  // namespace stats
