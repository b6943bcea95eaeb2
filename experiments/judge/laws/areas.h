#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// Who may not play the ball where (Law 12): a defender other than the goalie in its own defense area, an
/// attacker in the opponents'. The hull counts, as a disc, at the moment of a touch.
///
/// Ambiguous  when an opponent touched the ball within a tick of every contact that was a band deep. A
///            team-mate's touch, also the goalie's, excuses nobody: who touches there, offends.
/// Margin     the greatest depth of the hull in the area during the touch. It happens at the first contact
///            inside; it is clear at the first that is a band deep and not an opponent's too.
/// One        offence is counted for all touches less than 0.3 s apart, once it is clear.
class Areas {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Open {
    std::optional<TrueEvent> worst;
    std::size_t touch = 0;
    std::optional<world::Time> told;  // last contact of the last clear offence
  };
  void finish(Open& open, std::vector<TrueEvent>& out);

  std::array<Open, 2> open_;  // defender, attacker
};

/// A goalie that keeps the ball in its own area for too long (Law 12): touches it without
/// letting go for half a second.
///
/// Margin  two bands: a goalie that holds the ball for so long is clearly beyond the limit.
/// Near    let go in the last two bands of time.
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
