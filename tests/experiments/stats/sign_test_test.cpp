#include "experiments/stats/sign_test.h"

#include <gtest/gtest.h>

namespace stats {
namespace {

// Exact values by counting: 2 * sum of binomial coefficients / 2^n. Doubles hold them to about 1e-13.

TEST(SignTest, GivesTheCountedProbabilities) {
  EXPECT_NEAR(sign_test(5, 0), 2.0 / 32, 1e-13);
  EXPECT_NEAR(sign_test(9, 1), 2.0 * (10 + 1) / 1024, 1e-13);
  EXPECT_NEAR(sign_test(8, 2), 2.0 * (45 + 10 + 1) / 1024, 1e-13);
  EXPECT_NEAR(sign_test(15, 5), 2.0 * (15504 + 4845 + 1140 + 190 + 20 + 1) / 1048576, 1e-13);
}

TEST(SignTest, DoesNotCareWhichSideIsAhead) { EXPECT_EQ(sign_test(12, 3), sign_test(3, 12)); }

TEST(SignTest, OfAnEvenSplitIsOne) {
  EXPECT_EQ(sign_test(0, 0), 1);
  EXPECT_EQ(sign_test(7, 7), 1);
  EXPECT_EQ(sign_test(1, 0), 1);
}

TEST(SignTest, StillWorksForManyGames) {
  // 5200 of 10000: z = (5200 - 0.5 - 5000) / 50 = 3.99, two-sided normal tail 6.6e-5;
  // the exact value is near.
  EXPECT_NEAR(sign_test(5200, 4800), 6.6e-5, 0.1e-5);
}

}  // namespace
}  // namespace stats
