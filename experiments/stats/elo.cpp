#include "experiments/stats/elo.h"

#include <algorithm>
#include <cmath>

#include "experiments/stats/distributions.h"

namespace stats {

double elo(double score) { return -400 * std::log10(1 / score - 1); }

double expected_score(double elo) { return 1 / (1 + std::pow(10, -elo / 400)); }

EloEstimate elo_of(const Mean& scores, double confidence) {
  const double half = normal_quantile((1 + confidence) / 2) * scores.standard_error;
  return {elo(scores.mean),
          {elo(std::clamp(scores.mean - half, 0.0, 1.0)), elo(std::clamp(scores.mean + half, 0.0, 1.0))}};
}

double likelihood_of_superiority(const Mean& scores) {
  if (!scores.has_error()) return 0.5;
  const double off = scores.mean - 0.5;
  if (scores.standard_error == 0) return off == 0 ? 0.5 : off > 0 ? 1 : 0;
  return normal_cdf(off / scores.standard_error);
}

double normalised_elo(double t_per_game) { return t_per_game * 800 / std::log(10.0); }

}  // namespace stats
