#pragma once

#include "autoref/calibrate/noise.h"
#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// The fastest and hardest that robots moved: speed, speeding up and braking, forward and
/// sideways, and of turning.
///
/// Least squares of parabolas over 0.2 s (0.1 s for turning); those with residuals above 3 sigma are left out
/// (collisions, switches of command). Speeds are 99.9 % quantiles, accelerations 99 %, of what moved at all,
/// less the noise of one parabola. The sign of speed x acceleration along that axis, above 0.3 m/s or
/// 1 rad/s, tells speeding up from braking. What was never asked of a robot cannot be seen: these are lower
/// bounds of what it can do.
void add_robots(const Observations& seen, const Noise& noise, Report& report);

}  // namespace calibrate
