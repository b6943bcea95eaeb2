#pragma once

#include <array>
#include <deque>
#include <optional>

#include "sim/truth/truth.h"
#include "sim/world/tracked_frame.h"

namespace study {

/// What a touch did to the ball.
enum class Kind { Kick, Receive, Deflection, Dribble, Squeeze };
inline constexpr int kinds = 5;
const char* name(Kind kind);

/// A touch as the physics had it.
struct TrueTouch {
  world::RobotId robot;
  world::Time begin;
  world::Time end;
  double impulse = 0;  ///< [N s] sum
  bool kicked = false;
  bool squeezed = false;   ///< a robot of the other team touched it within a tick
  double speed_after = 0;  ///< [m/s] of the ball against the robot at the last contact so far
  double highest = 0;      ///< [m] the ball's lowest point since
  Kind kind() const;
};

/// The touches of a game from the engine's contacts: impulse of a substep above 1 mN s, those of one robot
/// less than 50 ms apart are one touch.
class TrueTouches {
 public:
  static constexpr double least_impulse = 0.001;  // [N s]
  static constexpr world::Duration apart = std::chrono::milliseconds{50};

  void add(const truth::Frame& frame);

  /// The last touch that began; null before the first.
  const TrueTouch* last() const { return last_; }
  /// When each team touched the ball last.
  const world::PerTeam<std::optional<world::Time>>& by_team() const { return by_team_; }
  /// The robot that touched the ball last, the one with the greater impulse when two did so in one substep.
  std::optional<world::RobotId> toucher() const { return toucher_; }
  const std::deque<TrueTouch>& all() const { return all_; }

 private:
  std::deque<TrueTouch> all_;  // a deque: `open_` points into it
  std::array<TrueTouch*, 2 * (world::max_robot_number + 1)> open_{};
  TrueTouch* last_ = nullptr;
  world::PerTeam<std::optional<world::Time>> by_team_;
  std::optional<world::RobotId> toucher_;
};

}  // namespace study
