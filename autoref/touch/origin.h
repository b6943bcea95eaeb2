#pragma once

#include <array>

#include "autoref/touch/likelihood.h"
#include "autoref/touch/views.h"
#include "sim/world/field.h"

namespace touch {

/// Where the present course of the ball began, and how well each robot explains that it began there.
struct Origin {
  struct Candidate {
    std::size_t robot = 0;              ///< slot
    double fit = 0;                     ///< [0, 1] 1: at the hull, pushed away from it
    world::Time time;                   ///< when it fits best
    Vector2d place = Vector2d::Zero();  ///< [m] of the ball then
  };
  bool found = false;    ///< the course has a beginning among the sightings
  world::Time earliest;  ///< between this
  world::Time latest;    ///< and this
  std::size_t count = 0;
  std::array<Candidate, Sighting::most_robots> candidates;

  /// Fit of the best one.
  double best() const;
  const Candidate* find(std::size_t robot) const;
};

/// Follows the course of the newest sightings back to the first that is not on it.
///
/// The course is straight, slowed by friction: least squares with a prior on the deceleration, one older
/// sighting after the other, as long as they are where it foretells them. One sighting off the course is
/// passed over when the next older one is on it. In the images round the break each robot is asked how near
/// its hull was to the course, whether the ball leaves it, and whether the change of velocity is a push.
///
/// @param noise  [m] of a sighting, per axis
/// @pre the newest Course::samples sightings are on one course
Origin trace_origin(const View& view, double noise, const world::Field& field);

}  // namespace touch
