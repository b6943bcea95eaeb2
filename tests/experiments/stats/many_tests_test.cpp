#include "experiments/stats/many_tests.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

namespace stats {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(Holm, MultipliesTheSmallestByAllAndTheLargestByOne) {
  // By hand: 0.005 * 4, 0.01 * 3, 0.03 * 2, then 0.04 * 1 raised to 0.06.
  EXPECT_THAT(holm(std::array{0.01, 0.04, 0.03, 0.005}),
              ElementsAre(DoubleEq(0.03), DoubleEq(0.06), DoubleEq(0.06), DoubleEq(0.02)));
}

TEST(Holm, IsNeverMoreThanOneAndLeavesASingleTestAlone) {
  EXPECT_THAT(holm(std::array{0.7, 0.9}), ElementsAre(1.0, 1.0));
  EXPECT_THAT(holm(std::array{0.03}), ElementsAre(0.03));
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace stats
