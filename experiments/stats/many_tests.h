#pragma once

#include <span>
#include <vector>

namespace stats {

/// p-values adjusted for being several (Holm): each may be compared with the usual level, and the probability
/// that any true "no difference" is rejected stays below that level, however the tests hang together.
///
/// Sorted p times (m, m - 1, ...), made non-decreasing, at most 1; returned in the order given.
///
/// Source  S. Holm, "A simple sequentially rejective multiple test procedure", 1979
std::vector<double> holm(std::span<const double> p);

}  // namespace stats
