#pragma once

#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// A restart's kick: that it was taken, who was where it may not be at that moment, and the kicker's second
/// touch (Laws 8, 9, 13, 15 to 17).
///
/// Taken    the ball is 50 mm from where it lay when the kick was signalled.
/// Second   touch: before any other robot does, the kicker touches the ball again once it is in play and has
///          been away from the kicker, or the kicker still pushes it in play.
/// Margins  of the kick: how far the ball went.
///          Of offenders: how much too near opponents and attackers stood, or how far over the halfway line.
///          Of a second touch: how far apart they had been, or how far the ball was pushed in play.
///          If it is not touched again: the gap, once they had been two bands apart.
class Kicks {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Restart {
    world::Vector2d place;  // [m] ball when it was signalled
    world::Team team{};
    bool kickoff = false;
    std::optional<std::size_t> first_touch{};
    // when the ball was touched last: the offenders may be sent off before the ball has gone 50 mm
    std::vector<truth::Robot> robots{};
    std::optional<TrueEvent> taken{};
    double farthest = 0;  // [m]
    bool reported = false;
  };
  struct Second {
    world::RobotId kicker;
    std::size_t first_touch = 0;
    world::Vector2d place;  // [m]
    double apart = 0;       // [m] greatest gap since
    std::optional<TrueEvent> pushed{};
    std::optional<TrueEvent> nearly{};
  };

  void take(const Moment& moment, std::vector<TrueEvent>& out);
  void look_around(const Moment& moment, std::vector<TrueEvent>& out) const;
  void watch_second(const Moment& moment, std::vector<TrueEvent>& out);
  void follow_ball(const Moment& moment);
  void end_second(std::vector<TrueEvent>& out);

  std::optional<Restart> restart_;
  std::optional<Second> second_;
  std::optional<world::Time> left_;     // SETUP
  std::optional<world::Time> stopped_;  // play
};

}  // namespace judge
