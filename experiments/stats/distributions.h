#pragma once

namespace stats {

/// P(X <= x) of the standard normal distribution.
double normal_cdf(double x);

/// The x with P(X <= x) = p of the standard normal distribution.
///
/// Starts from a rational guess and refines it with Newton steps on normal_cdf.
///
/// @pre 0 < p < 1
/// Accuracy  1e-12 for p in [1e-10, 1 - 1e-10]
double normal_quantile(double p);

/// P(T <= t) of Student's t distribution.
///
/// @param freedom  degrees of freedom, > 0
double t_cdf(double t, double freedom);

/// The t with P(T <= t) = p of Student's t distribution, found by bisection of t_cdf.
///
/// @pre 0 < p < 1, freedom > 0
/// Accuracy  1e-10 relative
double t_quantile(double p, double freedom);

/// The regularised incomplete beta function I_x(a, b).
///
/// Continued fraction, evaluated with Lentz's method from the side where it converges fast.
///
/// @pre 0 <= x <= 1, a > 0, b > 0
/// Source  NIST Digital Library of Mathematical Functions, 8.17.22
double incomplete_beta(double x, double a, double b);

/// P(X <= x) of the chi-square distribution: the regularised incomplete gamma function P(k/2, x/2).
///
/// Series below x = k + 2, continued fraction (Lentz) above.
///
/// @pre x >= 0, freedom > 0
/// Source  NIST Digital Library of Mathematical Functions, 8.11.4 and 8.9.2
double chi_square_cdf(double x, double freedom);

}  // namespace stats
