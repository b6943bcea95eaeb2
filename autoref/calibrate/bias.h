#pragma once

#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// Constant offsets of the cameras, from what two of them see at the same time.
///
/// For each pair of cameras: the median, over ball and robots, of the place seen by one less the place seen
/// by the other, interpolated to the same instant. Then offsets b_i with b_i - b_j nearest to these
/// differences, and sum zero within each group of cameras that meet. With n cameras in g groups
///
///   sigma^2 = sum |b|^2 / (2 (n - g))
///
/// which for two cameras with a difference D is D^2 / 4: differences have variance 2 sigma^2 per axis.
void add_bias(const Observations& seen, Report& report);

}  // namespace calibrate
