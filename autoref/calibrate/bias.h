#pragma once

#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// Constant offsets of the cameras, from what two of them see at the same time.
///
/// For each pair the median over ball and robots of (seen by one) - (seen by the other, interpolated to the
/// same instant); then offsets b_i with b_i - b_j nearest to these differences, sum zero within each group of
/// cameras that meet. With n cameras in g groups, sigma^2 = sum |b|^2 / (2 (n - g)): for two cameras
/// D^2 / 4 for a difference D, since differences have variance 2 sigma^2 per axis.
void add_bias(const Observations& seen, Report& report);

}  // namespace calibrate
