#pragma once

#include <array>
#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/crossing.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BOT_DRIBBLED_BALL_TOO_FAR: one robot moved the ball too far without letting go of it.
///
/// Rule    laws of 2015, Law 12, decision 5: at most 1 m, straight from where contact began.
/// Guard   |ball - start of dribble| - max_dribble  [m], rising, one guard per robot in contact.
/// Resets  when the ball has been out of the robot's reach for more than 10 frames (the authors' code): the
/// law
///         wants an observable separation, and reach flickers with the noise.
class DribbledTooFar final : public Detector {
 public:
  explicit DribbledTooFar(const world::RuleSet& rules) : max_distance_(rules.max_dribble) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override { dribbles_ = {}; }

 private:
  struct Dribble {
    world::Vector2d start;     // [m]
    world::GuardSample guard;  // at the last frame in contact
    int frames_apart = 0;
  };
  using OfTeam = std::array<std::optional<Dribble>, world::max_robot_number + 1>;

  double max_distance_;
  world::PerTeam<OfTeam> dribbles_;
};

}  // namespace detectors
