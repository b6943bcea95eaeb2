#pragma once

#include "autoref/detectors/ball_left_field.h"
#include "autoref/detectors/detector.h"

namespace detectors {

/// AIMLESS_KICK (icing): the ball went from a robot's own half over the opponents' goal line, beside the
/// goal, and nobody else touched it.
///
/// Rule    laws of 2015, Law 12, indirect free kicks; not at a kickoff, where the ball lies on the line.
/// Guard   that of BALL_LEFT_FIELD_GOAL_LINE, and the last touch at least icing_margin behind the halfway
///         line; in the same tick as that event, which it replaces.
/// Source  0.2 m of margin as TIGERs' autoref. Ours: a touch less probable than sure_touch is no icing.
class AimlessKick final : public Detector {
 public:
  explicit AimlessKick(const world::RuleSet& rules)
      : field_(rules.field), margin_(rules.icing_margin), sure_(rules.sure_touch), exit_(rules) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override { exit_.reset(); }

 private:
  world::Field field_;
  double margin_;
  double sure_;
  BallLeftField exit_;
};

}  // namespace detectors
