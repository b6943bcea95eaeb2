#pragma once

#include <optional>
#include <span>

#include "autoref/calibrate/linker.h"
#include "autoref/calibrate/statistics.h"

namespace calibrate {

/// A free ball on its straight way, decelerating in one phase or two.
struct BallFit {
  Estimate speed;                  ///< [m/s] at the first sighting
  Estimate first;                  ///< [m/s^2] deceleration, of the only phase when there is no second one
  std::optional<Estimate> second;  ///< [m/s^2]
  double switch_speed = 0;  ///< [m/s] where the second phase begins; without meaning when there is none
  double along = 0;         ///< [m] rms of the residuals along the way
  double across = 0;        ///< [m] and across it
};

/// Least squares of x(t) = x + v t - a t^2 / 2 along the way, and of the same with a second deceleration from
/// an instant that is searched for. Two phases are believed when they make the residuals smaller by an F of
/// 15 and the second deceleration is the smaller one by 0.5 m/s^2.
///
/// @pre  at least 8 sightings
BallFit fit_ball(std::span<const Sighting> sightings);

}  // namespace calibrate
