#pragma once

#include <string>

#include "experiments/bench/figures.h"

namespace bench {

/// Old and new side by side, one row a figure.
///
/// Times are compared as ratios to the reference scene of their own run, so that another clock speed of the
/// processor does not matter; memory, messages and games per hour as they are. Below 1 is better for costs.
std::string comparison(const Figures& before, const Figures& now);

}  // namespace bench
