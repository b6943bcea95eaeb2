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
/// Certain when the ball is seen at the robot, at once or later: a ball hidden by robots may be at another
/// one. Resets  when the ball has been away from the robot for more than 10 frames (the authors' code): the
/// law wants
///         an observable separation, and reach flickers with the noise. Away: out of its reach, and if hidden
///         also farther than 30 mm from its hull (ours: the tracker does not know how a hidden ball turns).
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
