#pragma once

#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/crossing.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// The restart's kick was taken, with the offences of that moment.
///
/// Rule    laws of 2015, Laws 8, 9, 13, 15 to 17: the ball is in play when it is kicked and moves;
///         opponents are then at least 0.5 m from it, the kicker's team-mates 0.2 m from the opponents'
///         defense area, and at a kickoff everyone is in its own half.
/// Guard   |ball - place| - kick_travel  [m], or speed - 0.4 m/s in two observed frames, 20 mm away in the
///         second and farther than in the first; the earlier of the two (reference "requirements", 1.10; the
///         distances and the second frame are ours, against hiccups of the filter).
/// Again   (Law 12, cautions 3 and 5: free kicks, goal kicks and corner kicks) when an opponent was near at
///         the last attempt too, of the same team from within 0.1 m.
/// Blames  the nearest robot of the team that may kick (I-34); a kick by an opponent shows
///         as an opponent near the ball. Distances are measured to where the ball lay:
///         a wall is not near because the ball flew at it. 20 mm of tolerance for the opponents,
///         as in TIGERs' autoref (reference "protocol", 6.4).
class KickTaken final : public Detector {
 public:
  explicit KickTaken(const world::RuleSet& rules)
      : field_(rules.field),
        travel_(rules.kick_travel),
        opponent_distance_(rules.opponent_distance),
        area_distance_(rules.attacker_area_distance) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {  // all but the last attempt: this one may be its retake
    moved_.reset();
    sped_up_.reset();
    reported_ = false;
  }

 private:
  std::optional<world::Time> when_taken(const world::TrackedFrame& frame, const world::GameState& state);

  world::Field field_;
  double travel_;
  double opponent_distance_;
  double area_distance_;
  std::optional<world::GuardSample> moved_;
  struct SpedUp {
    world::Time time;  // of the last frame before
    double distance;   // [m] in the first frame of it
  };
  std::optional<SpedUp> sped_up_;
  bool reported_ = false;

  struct Attempt {
    world::Team team;
    world::Vector2d place;  // [m]
  };
  std::optional<Attempt> spoilt_;  // the last kick, when an opponent was near
};

}  // namespace detectors
