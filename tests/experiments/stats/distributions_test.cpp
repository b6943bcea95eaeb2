#include "experiments/stats/distributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stats {
namespace {

// Printed tables give five or six digits; the tolerance is half of the last one.

TEST(NormalQuantile, GivesThePrintedValues) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959964, 5e-7);
  EXPECT_NEAR(normal_quantile(0.995), 2.575829, 5e-7);
  EXPECT_NEAR(normal_quantile(0.8), 0.841621, 5e-7);
}

TEST(NormalQuantile, IsTheInverseOfTheDistribution) {
  for (const double p : {1e-10, 1e-5, 0.01, 0.3, 0.5, 0.77, 0.999}) {
    EXPECT_NEAR(normal_cdf(normal_quantile(p)) / p, 1, 1e-12) << p;
  }
}

TEST(NormalQuantile, IsOdd) { EXPECT_DOUBLE_EQ(normal_quantile(0.1), -normal_quantile(0.9)); }

TEST(TQuantile, GivesThePrintedValues) {
  EXPECT_NEAR(t_quantile(0.975, 1), 12.7062, 5e-5);
  EXPECT_NEAR(t_quantile(0.975, 3), 3.18245, 5e-6);
  EXPECT_NEAR(t_quantile(0.975, 19), 2.09302, 5e-6);
  EXPECT_NEAR(t_quantile(0.95, 10), 1.81246, 5e-6);
}

TEST(TQuantile, OfOneDegreeOfFreedomIsCauchys) {
  // Closed form: tan(pi (p - 1/2)). Bisection stops at 1e-11 relative.
  for (const double p : {0.01, 0.2, 0.6, 0.9}) {
    const double exact = std::tan(std::numbers::pi * (p - 0.5));
    EXPECT_NEAR(t_quantile(p, 1), exact, 1e-9 * (1 + std::abs(exact))) << p;
  }
}

TEST(TQuantile, ApproachesTheNormalOneForManyDegreesOfFreedom) {
  // The first correction is (z^3 + z) / (4 nu) = 2.4e-6 here.
  EXPECT_NEAR(t_quantile(0.975, 1e6), normal_quantile(0.975), 3e-6);
}

TEST(IncompleteBeta, IsAPolynomialForWholeParameters) {
  // I_x(2, 3) = 6 x^2 - 8 x^3 + 3 x^4
  for (const double x : {0.0, 0.1, 0.5, 0.9, 1.0}) {
    const double exact = x * x * (6 + x * (-8 + 3 * x));
    EXPECT_NEAR(incomplete_beta(x, 2, 3), exact, 1e-14) << x;
  }
}

}  // namespace
}  // namespace stats
