#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// A robot stayed outside the field's boundary in play.
///
/// Rule    laws of 2015, Law 1, Law 5 decision 5 and Law 12 caution 7: beyond 0.25 m outside
///         the lines is the referee's walking area. Only doing so deliberately is punished,
///         which nobody can measure: it is noted.
/// Guard   centre of the robot outside the lines - run_off  [m] for run_off_time.
/// Resets  when the robot is back inside, to be noted again by 80 mm; one that stays out from one passage of
///         play to the next is noted once.
class RobotLeftField final : public Detector {
 public:
  explicit RobotLeftField(const world::RuleSet& rules)
      : field_(rules.field), run_off_(rules.run_off + rules.distance_margin), time_(rules.run_off_time) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    for (const world::Team team : world::both_teams) {
      for (Watched& watched : watched_[team]) watched.since.reset();
    }
  }

 private:
  struct Watched {
    std::optional<world::Time> since;  // outside, without a break
    bool reported = false;
  };

  world::Field field_;
  double run_off_;
  world::Duration time_;
  world::PerTeam<std::array<Watched, world::max_robot_number + 1>> watched_;
};

}  // namespace detectors
