#include "sim/vision/draws.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace {

using vision::Draws;

TEST(Draws, DependOnSeedNameAndAddressAlone) {
  const Draws draws(7, "a"), same(7, "a"), other_seed(8, "a"), other_name(7, "b");
  EXPECT_EQ(draws.uniform(3, 2, 1), same.uniform(3, 2, 1));
  std::set<double> different = {draws.uniform(3, 2, 1),      other_seed.uniform(3, 2, 1),
                                other_name.uniform(3, 2, 1), draws.uniform(4, 2, 1),
                                draws.uniform(3, 1, 1),      draws.uniform(3, 2, 0)};
  EXPECT_EQ(different.size(), 6U);
}

// Chi-square over 64 cells of pairs of neighbouring draws, along each of the three parts of an address:
// 63 degrees of freedom, so mean 63 and standard deviation sqrt(126); within 4 of these.
TEST(Draws, AreUniformAndNeighboursAreIndependent) {
  const Draws draws(1, "pairs");
  const int count = 100'000;
  for (const unsigned along : {0U, 1U, 2U}) {
    std::vector<int> cells(64, 0);
    for (int i = 0; i < count; ++i) {
      const auto image = static_cast<std::uint32_t>(i);
      const double a = draws.uniform(image, 3, 2);
      const double b = along == 0 ? draws.uniform(image + 1, 3, 2)
                                  : draws.uniform(image, 3 + (along == 1), 2 + (along == 2));
      ASSERT_TRUE(a >= 0 && a < 1);
      ++cells[static_cast<std::size_t>(8 * static_cast<int>(8 * a) + static_cast<int>(8 * b))];
    }
    double chi = 0;
    for (const int cell : cells) chi += std::pow(cell - count / 64.0, 2) / (count / 64.0);
    EXPECT_NEAR(chi, 63, 4 * std::sqrt(126)) << along;
  }
}

TEST(Draws, GaussiansHaveTheirMoments) {
  const Draws draws(1, "gaussian");
  const int count = 100'000;
  double sum = 0, squares = 0, fourth = 0;
  for (int i = 0; i < count; ++i) {
    const double g = draws.gaussian(static_cast<std::uint32_t>(i), 0, 2);
    sum += g;
    squares += g * g;
    fourth += g * g * g * g;
  }
  // Variances of g, g^2 and g^4: 1, 2 and 96. 4 standard errors.
  EXPECT_NEAR(sum / count, 0, 4 / std::sqrt(count));
  EXPECT_NEAR(squares / count, 1, 4 * std::sqrt(2.0 / count));
  EXPECT_NEAR(fourth / count, 3, 4 * std::sqrt(96.0 / count));
}

}  // namespace
