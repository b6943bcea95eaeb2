#pragma once

#include "autoref/calibrate/burst_fit.h"
#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// Images in which a camera should have seen something and did not.
///
/// Counted is what lies between two sightings of a track at most 4 s apart, as long as the straight way
/// between them stays inside the camera's view (not at its edge) and the object could not have left it
/// meanwhile. A ball with a robot's centre within 0.3 m may be hidden and is counted apart; an image that
/// shows a robot under another number is no loss, nor is one that never came.
void add_losses(const Observations& seen, Report& report);

}  // namespace calibrate
