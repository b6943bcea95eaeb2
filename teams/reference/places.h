#pragma once

#include <span>

#include "teams/reference/value_map.h"

namespace reference {

/// A grid point chosen for a supporter.
struct Place {
  int grid = -1;                         ///< its index; -1: there is none
  Vector2d position = Vector2d::Zero();  ///< [m]
  double value = 0;                      ///< V(q) [0..1]
  double ball_time = 0;                  ///< [s] of the pass
};

/// What both ways of choosing know of a supporter.
struct Chooser {
  const kit::Robot* robot = nullptr;
  double kick_time = 0;  ///< [s] until the pass can be played; 9 or more: nobody knows, P_reach is 1
  int before = -1;       ///< the grid point chosen last, 0.03 in its favour
};

/// Zones: the best point of the robot's own zone.
Place best_in_zone(const ValueMap& map, Zone zone, const Chooser& chooser);

/// Greedy: the best point of all, 1 m from each place in `taken`.
Place best_anywhere(const ValueMap& map, std::span<const Vector2d> taken, const Chooser& chooser);

/// Who goes to which of the first zones of `list`: the shortest sum of travel times, 0.3 s in favour of the
/// zone a robot has.
///
/// @param robots  at most most_supports
/// @param before  index of its zone (`index_of`) for each robot, -1: none
/// @return        for each robot the place in `list`
std::array<int, most_supports> assign_zones(const Partition& partition, const ZoneList& list,
                                            std::span<const kit::Robot* const> robots,
                                            std::span<const int> before);

}  // namespace reference
