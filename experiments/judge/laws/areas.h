#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// Who may not play the ball where (Law 12): a defender other than the goalie in its own defense area, an
/// attacker in the opponents'. The hull counts, as a disc, at the moment of a touch.
///
/// Ambiguous  when another robot, also a team-mate, touched the ball within a tick of each of these contacts.
/// Margin  the greatest depth of the hull in the area during the touch. It happens at the first contact
/// inside
///         and lasts as long as the touch is there. Repetitions within two seconds are the same offence.
class Areas {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Open {
    std::optional<TrueEvent> worst;
    std::optional<std::size_t> touch;
    std::optional<world::Time> reported;
  };
  void finish(Open& open, std::vector<TrueEvent>& out);

  std::array<Open, 2> open_;  // defender, attacker
};

/// A goalie that keeps the ball in its own area for too long (Law 12): touches it without letting go for half
/// a second.
///
/// Margin  two bands: who holds the ball for so long does not do it by a hair. Near misses: let go in the
/// last
///         two bands of time.
class KeeperHolds {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);
  /// The goalie that has the ball now.
  std::optional<world::RobotId> holder() const;

 private:
  struct Hold {
    world::RobotId keeper;
    world::Time since, last;
    bool reported = false;
  };
  std::optional<Hold> hold_;
};

}  // namespace judge
