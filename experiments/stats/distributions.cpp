#include "experiments/stats/distributions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace stats {
namespace {

double normal_density(double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }

/// I_x(a, b) by the continued fraction, quick for x < (a + 1) / (a + b + 2).
double beta_fraction(double x, double a, double b) {
  constexpr double tiny = 1e-300;  // stands for zero in Lentz's method
  constexpr double precision = 1e-15;
  constexpr int most_terms = 10'000;  // about sqrt(max(a, b)) are needed
  const double scale =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x)) /
      a;
  const auto not_zero = [](double value) { return std::abs(value) < tiny ? tiny : value; };
  double c = 1;
  double d = 1 / not_zero(1 - (a + b) * x / (a + 1));
  double fraction = d;
  for (int m = 1; m <= most_terms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    d = 1 / not_zero(1 + even * d);
    c = not_zero(1 + even / c);
    fraction *= c * d;
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    d = 1 / not_zero(1 + odd * d);
    c = not_zero(1 + odd / c);
    fraction *= c * d;
    if (std::abs(c * d - 1) < precision) break;
  }
  return scale * fraction;
}

}  // namespace

double normal_cdf(double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }

double normal_quantile(double p) {
  assert(p > 0 && p < 1);
  if (p > 0.5) return -normal_quantile(1 - p);
  // First guess: Abramowitz and Stegun 26.2.23, wrong by less than 4.5e-4.
  const double t = std::sqrt(-2 * std::log(p));
  double x = -(t - (2.515517 + 0.802853 * t + 0.010328 * t * t) /
                       (1 + 1.432788 * t + 0.189269 * t * t + 0.001308 * t * t * t));
  for (int step = 0; step < 4; ++step) x -= (normal_cdf(x) - p) / normal_density(x);
  return x;
}

double incomplete_beta(double x, double a, double b) {
  assert(x >= 0 && x <= 1 && a > 0 && b > 0);
  if (x == 0 || x == 1) return x;
  if (x < (a + 1) / (a + b + 2)) return beta_fraction(x, a, b);
  return 1 - beta_fraction(1 - x, b, a);
}

double t_cdf(double t, double freedom) {
  assert(freedom > 0);
  const double tail = incomplete_beta(freedom / (freedom + t * t), freedom / 2, 0.5) / 2;
  return t < 0 ? tail : 1 - tail;
}

double t_quantile(double p, double freedom) {
  assert(p > 0 && p < 1 && freedom > 0);
  if (p > 0.5) return -t_quantile(1 - p, freedom);
  double low = -1;
  while (t_cdf(low, freedom) > p) low *= 2;
  double high = 0;
  while (high - low > 1e-11 * (1 - low)) {
    const double middle = (low + high) / 2;
    (t_cdf(middle, freedom) > p ? high : low) = middle;
  }
  return (low + high) / 2;
}

double chi_square_cdf(double x, double freedom) {
  assert(x >= 0 && freedom > 0);
  if (x == 0) return 0;
  const double a = freedom / 2;
  const double z = x / 2;
  const double front = std::exp(a * std::log(z) - z - std::lgamma(a));
  constexpr double precision = 1e-16;
  constexpr int most_terms = 10'000;  // about sqrt(a) are needed near z = a
  if (z < a + 1) {
    double term = 1 / a;
    double sum = term;
    for (int n = 1; n <= most_terms && term > sum * precision; ++n) sum += term *= z / (a + n);
    return std::min(1.0, front * sum);
  }
  constexpr double tiny = 1e-300;
  double b = z + 1 - a;
  double c = 1 / tiny;
  double d = 1 / b;
  double fraction = d;
  for (int n = 1; n <= most_terms; ++n) {
    const double step = -n * (n - a);
    b += 2;
    d = 1 / (step * d + b);
    c = b + step / c;
    fraction *= c * d;
    if (std::abs(c * d - 1) < precision) break;
  }
  return 1 - front * fraction;
}

}  // namespace stats
