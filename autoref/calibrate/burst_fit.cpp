#include "autoref/calibrate/burst_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace calibrate {
namespace {

constexpr double tiny = 1e-300;  // instead of a probability of 0

// ln m, ln s, ln(L - 1)
using Logs = std::array<double, 3>;

double log_likelihood(const Gaps& gaps, const Logs& logs) {
  const double m = std::exp(logs[0]);
  const double s = std::exp(logs[1]);
  const double length = 1 + std::exp(logs[2]);
  if (m > 0.95 || s > 0.95 || length > 1000) return -std::numeric_limits<double>::infinity();
  // Chance of having missed so many images and being in that state.
  double good = 1;
  double burst = 0;
  double sum = 0;
  const std::size_t longest = std::max(gaps.ended.size(), gaps.open.size());
  for (std::size_t n = 0; n < longest; ++n) {
    const double now_good = good * (1 - s) + burst / length;
    const double now_burst = good * s + burst * (1 - 1 / length);
    if (n < gaps.open.size() && gaps.open[n] > 0) {
      sum += static_cast<double>(gaps.open[n]) * std::log(std::max(good + burst, tiny));
    }
    if (n < gaps.ended.size() && gaps.ended[n] > 0) {
      sum += static_cast<double>(gaps.ended[n]) * std::log(std::max(now_good * (1 - m), tiny));
    }
    good = now_good * m;
    burst = now_burst;
  }
  return sum;
}

// Steps along each axis, halved when none helps.
double climb(const Gaps& gaps, Logs& logs) {
  double best = log_likelihood(gaps, logs);
  for (double step = 1; step > 1e-4;) {
    bool improved = false;
    for (double& number : logs) {
      for (const double sign : {1.0, -1.0}) {
        const double before = number;
        number = std::clamp(number + sign * step, -20.0, 7.0);
        const double now = log_likelihood(gaps, logs);
        if (now > best) {
          best = now;
          improved = true;
          break;
        }
        number = before;
      }
    }
    if (!improved) step /= 2;
  }
  return best;
}

// Standard deviations of the logarithms from the curvature at the maximum.
Logs errors_at(const Gaps& gaps, const Logs& logs) {
  constexpr double h = 1e-3;
  Eigen::Matrix3d information;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = 0;
      for (const double a : {h, -h}) {
        for (const double b : {h, -h}) {
          Logs moved = logs;
          moved[static_cast<std::size_t>(i)] += a;
          moved[static_cast<std::size_t>(j)] += b;
          sum += (a * b > 0 ? 1 : -1) * log_likelihood(gaps, moved);
        }
      }
      information(i, j) = std::isfinite(sum) ? -sum / (4 * h * h) : 0;
    }
  }
  // A number without influence (no single misses at all) has no curvature: it must not spoil the others.
  information.diagonal().array() += 1e-6;
  const Eigen::Matrix3d covariance = information.inverse();
  Logs errors{};
  for (int i = 0; i < 3; ++i) {
    errors[static_cast<std::size_t>(i)] = std::sqrt(std::max(covariance(i, i), 0.0));
  }
  return errors;
}

}  // namespace

void Gaps::add(std::size_t missed, bool is_open) {
  std::vector<std::int64_t>& counts = is_open ? open : ended;
  if (counts.size() <= missed) counts.resize(missed + 1);
  ++counts[missed];
}

double Gaps::seen() const {
  return static_cast<double>(std::accumulate(ended.begin(), ended.end(), std::int64_t{0}));
}

double Gaps::missed() const {
  double sum = 0;
  for (const auto* counts : {&ended, &open}) {
    for (std::size_t n = 0; n < counts->size(); ++n) {
      sum += static_cast<double>((*counts)[n]) * static_cast<double>(n);
    }
  }
  return sum;
}

BurstFit fit_bursts(const Gaps& gaps) {
  const double seen = gaps.seen();
  const double missed = gaps.missed();
  const double images = seen + missed;
  const double share = missed / images;
  const auto samples = static_cast<std::size_t>(images);

  BurstFit fit;
  fit.missing = {share, std::sqrt(std::max(share, 1 / images) * (1 - share) / images), samples};
  fit.start = {0, 3 / images, samples};
  if (missed == 0) return fit;

  const double without = log_likelihood(gaps, {std::log(share), -40, 0});
  double with = -std::numeric_limits<double>::infinity();
  Logs best{};
  for (const double length : {3.0, 30.0}) {
    Logs logs = {std::log(share / 2), std::log(share / 2 / length), std::log(length - 1)};
    const double found = climb(gaps, logs);
    if (found > with) {
      with = found;
      best = logs;
    }
  }
  fit.evidence = 2 * (with - without);
  if (fit.evidence < 10) return fit;
  const Logs errors = errors_at(gaps, best);
  const double m = std::exp(best[0]);
  const double s = std::exp(best[1]);
  const double beyond_one = std::exp(best[2]);
  fit.missing = {m, std::min(m * errors[0], 3 / images + m), samples};
  fit.start = {s, s * errors[1], samples};
  fit.length = {1 + beyond_one, beyond_one * errors[2], samples};
  return fit;
}

}  // namespace calibrate
