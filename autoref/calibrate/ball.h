#pragma once

#include "autoref/calibrate/noise.h"
#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// Decelerations of a sliding and a rolling ball, the share of its speed at which rolling
/// begins, the fastest kick.
///
/// Takes each track of the ball apart where it is within 0.15 m of a robot, is slower than 0.2 m/s, was not
/// seen for 0.1 s or jumps in speed, and fits each piece of 0.25 s or more (`fit_ball`). Pieces that leave
/// residuals of more than 3 sigma and 3 mm are left out: chips (their projection is neither straight nor
/// evenly braked), deflections, dribbling. One phase alone counts as sliding from 1.5 m/s^2 on, as rolling up
/// to 1 m/s^2 and from 0.4 s on.
void add_ball(const Observations& seen, const Noise& noise, Report& report);

}  // namespace calibrate
