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
/// Certain at once. But if, while the ball was hidden, another robot was within 50 mm of it or it seemed to
///         be away from this robot, only when it is seen at this robot: another may have taken it (ours).
/// Begins  when the ball is within 20 mm of the hull, 30 mm when nobody sees it, not in flight.
/// Resets  when it is seen more than 30 mm away in two frames in a row: the law wants an observable
///         separation and says no number; 20 to 60 mm can be argued about (ours; the authors' code waits for
///         10 frames out of reach, in which a ball is pushed on and caught again).
class DribbledTooFar final : public Detector {
 public:
  explicit DribbledTooFar(const world::RuleSet& rules)
      : field_(rules.field), max_distance_(rules.max_dribble) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override { dribbles_ = {}; }

 private:
  struct Dribble {
    world::Vector2d start;                // [m]
    world::GuardSample guard;             // at the last frame in contact
    std::optional<world::Time> passed{};  // the limit, not certain yet
    bool doubtful = false;                // it may be at another robot
    int frames_apart = 0;
  };
  using OfTeam = std::array<std::optional<Dribble>, world::max_robot_number + 1>;

  bool another_near(const world::TrackedFrame& frame, world::RobotId robot,
                    const world::Vector2d& ball) const;

  world::Field field_;
  double max_distance_;
  world::PerTeam<OfTeam> dribbles_;
};

}  // namespace detectors
