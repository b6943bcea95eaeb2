#pragma once

#include <cassert>

namespace stats {

/// The zero of a monotone function between two ends with opposite signs, by halving: slow, and never wrong.
///
/// @pre function(low) and function(high) have opposite signs, or one of them is zero
/// Accuracy  to neighbouring doubles
template <class Function>
double root(Function function, double low, double high) {
  const bool rising = function(low) < function(high);
  for (int step = 0; step < 2000; ++step) {  // halving any two doubles takes fewer
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    ((function(middle) < 0) == rising ? low : high) = middle;
  }
  return low + (high - low) / 2;
}

}  // namespace stats
