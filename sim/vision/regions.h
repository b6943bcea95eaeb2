#pragma once

#include <vector>

#include "sim/vision/area.h"
#include "sim/vision/params.h"
#include "sim/world/random.h"

namespace vision {

/// The poorly calibrated regions of one camera: discs at places drawn once, each with an
/// error of its own direction.
class Regions {
 public:
  /// @param area  finite; the discs' centres are uniform in it
  Regions(const Params& params, const Area& area, world::RandomStream stream);

  bool contains(const world::Vector2d& point) const;

  /// Error of a position there [m]: `region_offset` at the centre of a disc, falling linearly to 0 at its
  /// rim; overlapping discs add up.
  world::Vector2d offset(const world::Vector2d& point) const;

 private:
  struct Region {
    world::Vector2d center;  // [m]
    world::Vector2d error;   // [m] at the centre
  };
  double radius_;  // [m]
  std::vector<Region> regions_;
};

}  // namespace vision
