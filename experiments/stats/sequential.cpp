#include "experiments/stats/sequential.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "experiments/stats/root.h"

namespace stats {
namespace {

struct Moments {
  double mean = 0;
  double variance = 0;
};

/// Of the scores 0, 1/(k-1), ..., 1 with these probabilities.
Moments moments(std::span<const double> probabilities) {
  const double step = 1 / static_cast<double>(probabilities.size() - 1);
  Moments result;
  for (std::size_t i = 0; i < probabilities.size(); ++i)
    result.mean += probabilities[i] * static_cast<double>(i) * step;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    const double off = static_cast<double>(i) * step - result.mean;
    result.variance += probabilities[i] * off * off;
  }
  return result;
}

/// The most likely distribution with sum p_i g_i = 0, given the observed one: p_i = q_i / (1 + x g_i).
/// Nothing when all g have the same sign: then there is none.
std::optional<std::vector<double>> most_likely(std::span<const double> observed, std::span<const double> g) {
  if (*std::max_element(g.begin(), g.end()) <= 0 || *std::min_element(g.begin(), g.end()) >= 0) {
    return std::nullopt;
  }
  const double low = -1 / *std::max_element(g.begin(), g.end());
  const double high = -1 / *std::min_element(g.begin(), g.end());
  const auto equation = [&](double x) {
    double sum = 0;
    for (std::size_t i = 0; i < g.size(); ++i) sum += observed[i] * g[i] / (1 + x * g[i]);
    return sum;
  };
  const double margin = 1e-9;  // the equation has poles at both ends
  const double x = root(equation, low + margin, high - margin);
  std::vector<double> result(g.size());
  for (std::size_t i = 0; i < g.size(); ++i) result[i] = observed[i] / (1 + x * g[i]);
  return result;
}

std::vector<double> with_expectation(std::span<const double> observed, double s) {
  const double step = 1 / static_cast<double>(observed.size() - 1);
  std::vector<double> g(observed.size());
  for (std::size_t i = 0; i < g.size(); ++i) g[i] = static_cast<double>(i) * step - s;
  return *most_likely(observed, g);
}

/// The constraint (mean - 1/2) / deviation = t, made linear around a mean and a deviation: sum p_i g_i = 0.
std::vector<double> linear_constraint(std::size_t classes, double t, double mean, double deviation) {
  const double step = 1 / static_cast<double>(classes - 1);
  std::vector<double> g(classes);
  for (std::size_t i = 0; i < classes; ++i) {
    const double score = static_cast<double>(i) * step;
    const double off = (score - mean) / deviation;
    g[i] = score - 0.5 - t * deviation * (1 + off * off) / 2;
  }
  return g;
}

/// Solved, made linear around the solution, and solved again. Nothing when that leads nowhere, as it does
/// above t = 0.94: no distribution fulfils the constraint that is linear around equal shares.
std::optional<std::vector<double>> with_effect_by_rounds(std::span<const double> observed, double t) {
  std::vector<double> found(observed.size(), 1 / static_cast<double>(observed.size()));
  for (int round = 0; round < 200; ++round) {
    const Moments now = moments(found);
    if (!(now.variance > 0)) return std::nullopt;
    auto next =
        most_likely(observed, linear_constraint(observed.size(), t, now.mean, std::sqrt(now.variance)));
    if (!next) return std::nullopt;
    double change = 0;
    for (std::size_t i = 0; i < found.size(); ++i) change = std::max(change, std::abs((*next)[i] - found[i]));
    found = *std::move(next);
    if (change < 1e-9) return found;
  }
  return std::nullopt;
}

/// The same by trying every deviation. A solution is that of its own linear constraint, around the mean
/// 1/2 + t * deviation, so all of them are zeros of one function of the deviation. For large t there may be
/// several; the likeliest is taken.
///
/// @pre t != 0
std::vector<double> with_effect_by_scan(std::span<const double> observed, double t) {
  constexpr int steps = 200;
  const double largest = 0.5 / std::abs(t);  // the mean is a score, from 0 to 1
  const auto solved = [&](double deviation) {
    return most_likely(observed, linear_constraint(observed.size(), t, 0.5 + t * deviation, deviation));
  };
  const auto miss = [&](double deviation) -> std::optional<double> {
    const auto p = solved(deviation);
    if (!p) return std::nullopt;
    return moments(*p).mean - 0.5 - t * deviation;
  };
  std::vector<double> best;
  double best_likelihood = 0;
  std::vector<double> nearest(observed.begin(), observed.end());
  double least_miss = std::numeric_limits<double>::infinity();
  std::optional<double> before;
  for (int i = 1; i < steps; ++i) {
    const double here = largest * i / steps;
    const std::optional<double> now = miss(here);
    if (now && std::abs(*now) < least_miss) {
      least_miss = std::abs(*now);
      nearest = *solved(here);
    }
    if (before && now && *before * *now <= 0) {
      const double zero =
          root([&](double x) { return miss(x).value_or(0); }, largest * (i - 1) / steps, here);
      if (auto p = solved(zero)) {
        double likelihood = 0;
        for (std::size_t k = 0; k < p->size(); ++k) likelihood += observed[k] * std::log((*p)[k]);
        if (best.empty() || likelihood > best_likelihood) {
          best_likelihood = likelihood;
          best = *std::move(p);
        }
      }
    }
    before = now;
  }
  // Of 50,000 pairs that all went the same way a zero is between two steps, and where it
  // is makes no difference.
  return best.empty() ? nearest : best;
}

/// The most likely distribution with (mean - 1/2) / deviation = t.
std::vector<double> with_effect(std::span<const double> observed, double t) {
  if (auto found = with_effect_by_rounds(observed, t)) return *std::move(found);
  return with_effect_by_scan(observed, t);
}

struct Observed {
  double total = 0;
  std::vector<double> shares;
};

Observed observed(std::span<const double> counts) {
  assert(counts.size() >= 2);
  constexpr double instead_of_none = 1e-3;
  Observed result;
  for (const double count : counts) {
    result.shares.push_back(count > 0 ? count : instead_of_none);
    result.total += result.shares.back();
  }
  for (double& share : result.shares) share /= result.total;
  return result;
}

double ratio(const Observed& seen, std::span<const double> p0, std::span<const double> p1) {
  double sum = 0;
  for (std::size_t i = 0; i < p0.size(); ++i) sum += seen.shares[i] * std::log(p1[i] / p0[i]);
  return seen.total * sum;
}

/// Of one normal score, from mean m and variance v of what was seen; see the header.
double normal_ratio(double m, double v, const Hypotheses& hypotheses) {
  const double squares = v + m * m;
  if (squares == 0) return (hypotheses.t0 * hypotheses.t0 - hypotheses.t1 * hypotheses.t1) / 2;
  const auto l = [&](double t) {
    const double sigma = (std::sqrt(t * t * m * m + 4 * squares) - t * m) / 2;
    return std::log(sigma) + squares / (2 * sigma * sigma) - t * m / sigma + t * t / 2;
  };
  return l(hypotheses.t0) - l(hypotheses.t1);
}

/// Mean and deviation of a growing number of values (Welford).
struct Running {
  double count = 0;
  double mean = 0;
  double squares = 0;
  void add(double value) {
    count += 1;
    const double off = value - mean;
    mean += off / count;
    squares += off * (value - mean);
  }
  Mean result() const {
    Mean out;
    out.count = static_cast<std::int64_t>(count);
    out.mean = mean;
    if (count < 2) return out;
    out.deviation = std::sqrt(squares / (count - 1));
    out.standard_error = out.deviation / std::sqrt(count);
    return out;
  }
};

}  // namespace

Bounds wald_bounds(double alpha, double beta) {
  assert(alpha > 0 && beta > 0 && alpha + beta < 1);
  return {std::log(beta / (1 - alpha)), std::log((1 - beta) / alpha)};
}

double normalised_llr(const Mean& scores, const Hypotheses& hypotheses, double reference) {
  if (!scores.has_error()) return 0;
  const double n = static_cast<double>(scores.count);
  const double variance = scores.deviation * scores.deviation * (n - 1) / n;
  return n * normal_ratio(scores.mean - reference, variance, hypotheses);
}

double expected_llr(double t, const Hypotheses& hypotheses) { return normal_ratio(t, 1, hypotheses); }

double llr_variance(double t, const Hypotheses& hypotheses) {
  constexpr double step = 1e-5;
  const double slope = (expected_llr(t + step, hypotheses) - expected_llr(t - step, hypotheses)) / (2 * step);
  return slope * slope * (1 + t * t / 2);
}

Pentanomial pentanomial(std::span<const double> scores) {
  Pentanomial counts{};
  for (const double score : scores) {
    assert(score >= 0 && score <= 1 && score * 4 == std::floor(score * 4));
    counts.at(static_cast<std::size_t>(score * 4)) += 1;
  }
  return counts;
}

double multinomial_llr(std::span<const double> counts, double s0, double s1) {
  const Observed seen = observed(counts);
  return ratio(seen, with_expectation(seen.shares, s0), with_expectation(seen.shares, s1));
}

double multinomial_llr(std::span<const double> counts, const Hypotheses& hypotheses) {
  const Observed seen = observed(counts);
  return ratio(seen, with_effect(seen.shares, hypotheses.t0), with_effect(seen.shares, hypotheses.t1));
}

void Overshoot::add(double llr) {
  if (!std::exchange(begun_, true)) {
    lowest_ = highest_ = llr;
    return;
  }
  if (llr < lowest_) {
    sum_low_ += lowest_ - llr;
    squares_low_ += (lowest_ - llr) * (lowest_ - llr);
    lowest_ = llr;
  }
  if (llr > highest_) {
    sum_high_ += llr - highest_;
    squares_high_ += (llr - highest_) * (llr - highest_);
    highest_ = llr;
  }
}

Bounds Overshoot::tightened(const Bounds& bounds) const {
  const double low = sum_low_ > 0 ? squares_low_ / sum_low_ / 2 : 0;
  const double high = sum_high_ > 0 ? squares_high_ / sum_high_ / 2 : 0;
  // A single step beyond both bounds must not turn them round.
  return {std::min(bounds.lower + low, bounds.lower / 2), std::max(bounds.upper - high, bounds.upper / 2)};
}

const char* name(Decision decision) {
  constexpr std::array<const char*, 4> names = {"go on", "H0", "H1", "undecided"};
  return names.at(static_cast<std::size_t>(decision));
}

double clipped(double score, const SequentialPlan& plan) {
  return plan.clip > 0 ? std::clamp(score, -plan.clip, plan.clip) : score;
}

SequentialState sequential_test(std::span<const double> scores, const SequentialPlan& plan) {
  assert(plan.first_look >= 2 && plan.batch >= 1 && plan.hypotheses.t0 != plan.hypotheses.t1);
  const Bounds asked = wald_bounds(plan.alpha, plan.beta);
  SequentialState state;
  state.bounds = asked;
  Overshoot overshoot;
  Running running;
  Pentanomial counts{};
  const std::int64_t last = std::min(static_cast<std::int64_t>(scores.size()), plan.cap);
  for (std::int64_t n = 1; n <= last; ++n) {
    const double score = clipped(scores[static_cast<std::size_t>(n - 1)], plan);
    if (plan.metric == Metric::Points) {
      counts.at(static_cast<std::size_t>(score * 4)) += 1;
    } else {
      running.add(score);
    }
    const bool look = n >= plan.first_look && (n - plan.first_look) % plan.batch == 0;
    if (!look && n != plan.cap) continue;
    state.used = n;
    state.llr = plan.metric == Metric::Points ? multinomial_llr(counts, plan.hypotheses)
                                              : normalised_llr(running.result(), plan.hypotheses);
    overshoot.add(state.llr);
    state.bounds = overshoot.tightened(asked);
    if (state.llr <= state.bounds.lower) {
      state.decision = Decision::AcceptH0;
      return state;
    }
    if (state.llr >= state.bounds.upper) {
      state.decision = Decision::AcceptH1;
      return state;
    }
  }
  if (last == plan.cap) state.decision = Decision::Undecided;
  return state;
}

ExpectedCourse expected_course(const SequentialPlan& plan, double t) {
  const Bounds bounds = wald_bounds(plan.alpha, plan.beta);
  const double drift = expected_llr(t, plan.hypotheses);
  const double variance = llr_variance(t, plan.hypotheses);
  ExpectedCourse result;
  const double h = -2 * drift / variance;  // exp(h LLR) is a martingale
  if (std::abs(h) < 1e-5) {                // half way: the quotient of small differences below would be noise
    result.accept_h1 = -bounds.lower / (bounds.upper - bounds.lower);
    result.pairs = -bounds.lower * bounds.upper / variance;
    return result;
  }
  result.accept_h1 =
      std::expm1(h * bounds.lower) / (std::expm1(h * bounds.lower) - std::expm1(h * bounds.upper));
  result.pairs = (result.accept_h1 * bounds.upper + (1 - result.accept_h1) * bounds.lower) / drift;
  return result;
}

}  // namespace stats
