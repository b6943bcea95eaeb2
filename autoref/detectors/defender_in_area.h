#pragma once

#include "autoref/detectors/area_touches.h"
#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// DEFENDER_IN_DEFENSE_AREA, ..._PARTIALLY: a robot touched the ball in play in its own defense area.
///
/// Rule    laws of 2015, Law 12: wholly inside a penalty kick; partly a yellow card (caution 8) and an
///         indirect free kick (I-9). The goalie is exempt (I-8).
/// Guard   a certain touch (AreaTouches, sure_touch) by a robot whose hull reached distance_margin into the
///         area at that time, or was all inside by distance_margin.
/// Resets  when there was no offence for 2 s (TIGERs): one that goes on is one.
class DefenderInArea final : public Detector {
 public:
  explicit DefenderInArea(const world::RuleSet& rules)
      : field_(rules.field), margin_(rules.distance_margin), touches_(rules.field, rules.sure_touch) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    touches_.reset();
    last_.reset();
  }

 private:
  world::Field field_;
  double margin_;
  AreaTouches touches_;
  std::optional<world::Time> last_;  // offence, reported or going on
};

}  // namespace detectors
