#pragma once

#include "autoref/calibrate/observations.h"
#include "autoref/calibrate/report.h"

namespace calibrate {

/// False balls, misread and unread robot numbers, and the noise of the ball's area.
///
/// A false ball is a track that was elsewhere while a better one saw the ball; its length counts from its
/// first to its last image, the shortest and longest are the 2.5 and 97.5 % quantiles. A robot is misread or
/// unread when a pattern of its team with another number, or none, lies where it was. Area: robust spread of
/// differences from one image to the next, over sqrt 2.
void add_mistakes(const Observations& seen, Report& report);

}  // namespace calibrate
