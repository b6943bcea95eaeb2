#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// ATTACKER_TOUCHED_OPPONENT_IN_DEFENSE_AREA: a robot touched the opponents' goalie in the goalie's area.
///
/// Rule    laws of 2015, Law 12, indirect free kicks: the point of contact is in the defense area; whoever of
///         them moved. The event's name is the league's of that time.
/// Guard   2 robot_radius + 1 mm - distance of the centres  [m], in two frames in which both were seen, the
///         middle between them in the area by distance_margin.
/// Resets  when the hulls are 20 mm apart.
/// Source  two frames: ours, against one frame's noise. They need not be in a row: hulls bounce.
class KeeperContact final : public Detector {
 public:
  explicit KeeperContact(const world::RuleSet& rules) : field_(rules.field), margin_(rules.distance_margin) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override { frames_ = {}; }

 private:
  world::Field field_;
  double margin_;
  world::PerTeam<std::array<int, world::max_robot_number + 1>> frames_{};  // in contact, by attacker
};

}  // namespace detectors
