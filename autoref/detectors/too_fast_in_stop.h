#pragma once

#include <array>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// BOT_TOO_FAST_IN_STOP: a robot drove too fast while play was stopped.
///
/// Rule    laws of 2015, Law 12, caution 9 and decision 10: at most 1.5 m/s, only while the command is STOP
///         (or GOAL, which counts as STOP).
/// Guard   speed - stop_speed - stop_speed_margin  [m/s] for stop_violation, from stop_grace after the
///         command.
/// Resets  a robot is reported once per stoppage.
/// Source  grace, margin and duration: reference "protocol", 6.4.
class TooFastInStop final : public Detector {
 public:
  explicit TooFastInStop(const world::RuleSet& rules)
      : limit_(rules.stop_speed + rules.stop_speed_margin),
        grace_(rules.stop_grace),
        violation_(rules.stop_violation) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override { watched_ = {}; }

 private:
  struct Watched {
    std::optional<world::Time> since;  // too fast, without a break
    bool reported = false;
  };

  double limit_;
  world::Duration grace_;
  world::Duration violation_;
  world::PerTeam<std::array<Watched, world::max_robot_number + 1>> watched_;
};

}  // namespace detectors
