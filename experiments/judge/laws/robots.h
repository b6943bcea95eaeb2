#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"
#include "experiments/judge/laws/window.h"

namespace judge {

/// Robots that are outside the field for too long (Law 12, caution 7), and teams with too many (Law 3).
///
/// Once     for a robot that stays out from one passage of play to the next.
/// Margins  how far beyond the run-off the robot stayed for all of the time; two bands for a robot too many,
///          or the time if it was off again soon.
class RobotsOff {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Watched {
    Window window;
    std::optional<TrueEvent> worst{};
    bool passed = false;
    bool told = false;  // in an earlier passage of play, and not back since
  };
  void finish(Watched& watched, std::vector<TrueEvent>& out);

  std::array<Watched, robot_slots> robots_;
  world::PerTeam<std::optional<world::Time>> too_many_since_;
  world::PerTeam<bool> reported_{};
  world::PerTeam<int> allowed_{};
};

}  // namespace judge
