#pragma once

#include <array>

#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// The noise of moving things, errors of the time of capture included: for the estimators of motion.
struct Noise {
  double ball = 0.0005;         ///< [m] per axis
  double robot = 0.00055;       ///< [m] per axis
  double orientation = 0.0035;  ///< [rad]
};

/// Noise of ball, robots and orientations, per camera and of all.
///
/// Of every four sightings in a row (within 0.12 s, any spacing) the third divided difference, which no
/// constant acceleration moves, brought to the noise of one sighting; then their robust spread. Of moving
/// things only the component across their way counts: along it errors of the time of capture add. Sees what
/// changes from image to image only: slow errors are bias.
///
/// @return what was found; where nothing was, the preset's
Noise add_noise(const Observations& seen, Report& report);

/// The third divided difference of four values at four times, scaled to the standard deviation of one value.
double third_difference(const std::array<double, 4>& times, const std::array<double, 4>& values);

}  // namespace calibrate
