#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BOT_INTERFERED_PLACEMENT: a robot stood in the way of the ball that is to be put in its place.
///
/// Rule    laws of 2015, Law 9 with decision 10 of Law 12: robots keep away while the referee controls the
///         ball. No punishment is named: it is noted. The measure is that of the later laws.
/// Guard   stop_distance - distance_margin - (hull to the way from the ball to its place)  [m]
///         for stop_grace, while the ball is not in its place. A ball that nobody sees is where the filter
///         believes it to be; that a robot is out of the way is known only when the ball is seen.
/// Resets  a robot is reported once per stoppage.
/// Source  2 s and the distance to the segment: reference "protocol", 6.3 and 6.4.
class InterferedPlacement final : public Detector {
 public:
  explicit InterferedPlacement(const world::RuleSet& rules)
      : field_(rules.field),
        distance_(rules.stop_distance - rules.distance_margin),
        tolerance_(rules.placement_tolerance),
        grace_(rules.stop_grace) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override { watched_ = {}; }

 private:
  struct Watched {
    std::optional<world::Time> since;  // in the way, without a break
    bool reported = false;
  };

  world::Field field_;
  double distance_;
  double tolerance_;
  world::Duration grace_;
  world::PerTeam<std::array<Watched, world::max_robot_number + 1>> watched_;
};

}  // namespace detectors
