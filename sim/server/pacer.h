#pragma once

#include <chrono>

#include "sim/world/time.h"

namespace server {

/// When simulated instants are due on the machine's clock, at a speed that may change.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;

  /// Later than this a tick is not caught up with: the schedule moves instead. Ours: long enough for a hiccup
  /// of the machine, short enough that a team does not see time race for long.
  static constexpr Clock::duration most_lag = std::chrono::milliseconds{100};

  /// @param speed  simulated seconds in a second; 0: time stands still
  Pacer(Clock::time_point now, world::Time simulated, double speed);

  /// The end of time while paused.
  Clock::time_point due(world::Time simulated) const;

  /// From now on at another speed. `next` is the next tick: simulated time never passes it here.
  void set_speed(Clock::time_point now, world::Time next, double speed);
  double speed() const { return speed_; }

  /// When `next` was due more than `most_lag` ago, moves the schedule so that it is due `most_lag` ago.
  /// @returns by how much, else zero
  Clock::duration give_up(Clock::time_point now, world::Time next);

 private:
  world::Time simulated(Clock::time_point now) const;

  Clock::time_point origin_;
  world::Time simulated_origin_;
  double speed_;
};

}  // namespace server
