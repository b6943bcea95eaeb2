#pragma once

#include <cstdint>

namespace stats {

/// Probability of a split at least as uneven as `wins` to `losses`, to either side, if both were equally
/// likely; draws are left out. 1 when there are none.
///
/// Exact, two-sided: twice the smaller tail of the binomial distribution with p = 1/2, at most 1.
///
/// @pre wins >= 0, losses >= 0
/// Accuracy  1e-12 relative up to a million games
double sign_test(std::int64_t wins, std::int64_t losses);

}  // namespace stats
