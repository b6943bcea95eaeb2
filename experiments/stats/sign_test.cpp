#include "experiments/stats/sign_test.h"

#include <algorithm>
#include <cassert>

#include "experiments/stats/distributions.h"

namespace stats {

double sign_test(std::int64_t wins, std::int64_t losses) {
  assert(wins >= 0 && losses >= 0);
  if (wins == losses) return 1;
  // P(X >= k) of n fair coins is I_{1/2}(k, n - k + 1).
  const double more = static_cast<double>(std::max(wins, losses));
  const double fewer = static_cast<double>(std::min(wins, losses));
  return std::min(1.0, 2 * incomplete_beta(0.5, more, fewer + 1));
}

}  // namespace stats
