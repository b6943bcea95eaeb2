#include "sim/world/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace world {
namespace {

TEST(RandomStream, SameSeedAndNameGiveTheSameNumbers) {
  RandomStream a(7, "vision noise");
  RandomStream b(7, "vision noise");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.gaussian(), b.gaussian());
}

TEST(RandomStream, AnotherNameOrSeedGivesOthers) {
  EXPECT_NE(derived_seed(7, "vision noise"), derived_seed(7, "kicker scatter"));
  EXPECT_NE(derived_seed(7, "vision noise"), derived_seed(8, "vision noise"));
}

TEST(RandomStream, UniformStaysBelowOneAndFillsItsTenths) {
  RandomStream stream(3, "uniform test");
  int tenths[10] = {};
  constexpr int n = 100'000;
  for (int i = 0; i < n; ++i) {
    const double u = stream.uniform();
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    ++tenths[static_cast<int>(u * 10)];
  }
  // Binomial(n, 0.1): five standard deviations; false alarm 6e-7 per tenth, and the seed is fixed.
  for (const int count : tenths) EXPECT_NEAR(count, n * 0.1, 5 * std::sqrt(n * 0.09));
}

TEST(RandomStream, GaussianHasMeanZeroAndVarianceOne) {
  RandomStream stream(4, "gaussian test");
  constexpr int n = 100'000;
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < n; ++i) {
    const double g = stream.gaussian();
    sum += g;
    squares += g * g;
  }
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));            // five standard errors
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));  // variance of g^2 is 2
}

TEST(RandomStream, BelowNeverReachesItsBound) {
  RandomStream stream(5, "below test");
  for (int i = 0; i < 1000; ++i) EXPECT_LT(stream.below(3), 3u);
}

}  // namespace
}  // namespace world
