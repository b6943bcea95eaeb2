#include "experiments/stopping/estimate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "experiments/stats/random.h"

namespace stopping {
namespace {

constexpr int halvings = 14;  // of the range searched: to a thousandth of a standard error
constexpr double range = 8;   // [standard errors] to both sides of the effect seen
constexpr std::size_t first_scores = 64;

/// Standard normal numbers from a seed, by Box and Muller.
class Normals {
 public:
  explicit Normals(std::uint64_t seed) : random_(seed) {}
  double next() {
    if (spare_) {
      spare_ = false;
      return kept_;
    }
    const double radius = std::sqrt(-2 * std::log(1 - random_.uniform()));
    const double angle = 2 * std::numbers::pi * random_.uniform();
    kept_ = radius * std::sin(angle);
    spare_ = true;
    return radius * std::cos(angle);
  }

 private:
  stats::Random random_;
  double kept_ = 0;
  bool spare_ = false;
};

/// The effect that a test with these numbers, moved by t, ends with. `scores` is room to work in.
double effect_at_stop(std::vector<double>& normals, Normals& source, double t,
                      const stats::SequentialPlan& plan, std::vector<double>& scores) {
  const auto cap = static_cast<std::size_t>(plan.cap);
  for (std::size_t count = std::min(cap, first_scores);; count = std::min(cap, 2 * count)) {
    while (normals.size() < count) normals.push_back(source.next());
    scores.resize(count);
    std::transform(normals.begin(), normals.begin() + static_cast<std::ptrdiff_t>(count), scores.begin(),
                   [t](double normal) { return t + normal; });
    const stats::SequentialState state = stats::sequential_test(scores, plan);
    if (state.decision == stats::Decision::GoOn && count < cap) continue;
    const stats::Mean mean = stats::mean_of(std::span(scores).first(static_cast<std::size_t>(state.used)));
    return mean.mean / mean.deviation;
  }
}

}  // namespace

stats::Estimate corrected_effect(double seen, int pairs, const stats::SequentialPlan& plan, int runs) {
  stats::SequentialPlan test = plan;
  test.metric = stats::Metric::GoalDifference;  // the scores are any numbers here
  test.clip = 0;                                // and clipped already

  std::vector<Normals> sources;
  for (int run = 0; run < runs; ++run) {
    sources.emplace_back(stats::resampling_seed + static_cast<std::uint64_t>(run));
  }
  std::vector<std::vector<double>> normals(sources.size());
  std::vector<double> scores;
  const auto share_at_most = [&](double t) {
    int count = 0;
    for (std::size_t run = 0; run < sources.size(); ++run) {
      if (effect_at_stop(normals[run], sources[run], t, test, scores) <= seen) ++count;
    }
    return static_cast<double>(count) / runs;
  };
  const double error = std::sqrt((1 + seen * seen / 2) / pairs);
  const auto effect_with = [&](double share) {  // share_at_most falls with t
    double low = seen - range * error;
    double high = seen + range * error;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      (share_at_most(middle) > share ? low : high) = middle;
    }
    return (low + high) / 2;
  };
  const double tail = (1 - stats::usual_confidence) / 2;
  stats::Estimate estimate;
  estimate.value = effect_with(0.5);
  estimate.interval = {effect_with(1 - tail), effect_with(tail)};
  return estimate;
}

stats::Estimate corrected(const Standing& standing, const schedule::Design& design) {
  const stats::SequentialPlan plan = sequential_plan(design, standing.question, questions(design).size());
  const double equal = plan.metric == stats::Metric::Points ? 0.5 : 0;
  const double deviation = standing.score.deviation;
  if (!(deviation > 0)) return {standing.score.mean, {standing.score.mean, standing.score.mean}};
  stats::Estimate estimate =
      corrected_effect((standing.score.mean - equal) / deviation, standing.pairs, plan);
  estimate.value = equal + deviation * estimate.value;
  estimate.interval.low = equal + deviation * estimate.interval.low;
  estimate.interval.high = equal + deviation * estimate.interval.high;
  return estimate;
}

}  // namespace stopping
