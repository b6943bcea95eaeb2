#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "sim/truth/truth.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace judge {

/// What a touch did to the ball.
enum class Kind : std::uint8_t { Kick, Receive, Deflection, Dribble, Squeeze };
inline constexpr std::size_t kinds = 5;
std::string_view name(Kind kind);
std::optional<Kind> kind_named(std::string_view name);

inline constexpr world::Duration one_tick = std::chrono::microseconds{16'667};

/// A touch as the physics had it.
struct TrueTouch {
  world::RobotId robot;
  world::Time begin;
  world::Time end;
  world::Vector2d place = world::Vector2d::Zero();  ///< [m] ball at the last contact so far
  double impulse = 0;                               ///< [N s] sum
  bool kicked = false;
  bool squeezed = false;   ///< a robot of the other team touched it within a tick
  double speed_after = 0;  ///< [m/s] of the ball against the robot at the last contact so far
  double highest = 0;      ///< [m] the ball's lowest point since, as long as it is the last touch
  bool in_play = false;    ///< it began in play
  Kind kind() const;
};

/// The touches of a game from the engine's contacts: impulse of a substep above 1 mN s; those of one robot
/// less than 50 ms apart are one touch.
class TrueTouches {
 public:
  static constexpr double least_impulse = 0.001;  // [N s]
  static constexpr world::Duration apart = std::chrono::milliseconds{50};

  void add(const truth::Frame& frame, bool in_play);

  /// One contact above the least impulse, and the touch it belongs to.
  struct Contact {
    world::Time time;
    std::size_t touch = 0;  ///< index into all()
    double impulse = 0;     ///< [N s]
  };

  /// The last contact not after `time`, the one with the greater impulse when two robots touched in that
  /// substep; null when there is none in the last seconds.
  const Contact* last_at(world::Time time) const;
  /// Whether robots of both teams touched within one tick up to that contact.
  bool ambiguous(const Contact& contact) const;
  /// How long before that contact the other team had its last one [s]; 1e9 when it is longer ago than the
  /// contacts that are remembered.
  double alone(const Contact& contact) const;
  /// Those of the last frame, in order of time.
  const std::vector<Contact>& fresh() const { return fresh_; }

  const std::deque<TrueTouch>& all() const { return all_; }
  const TrueTouch& operator[](std::size_t index) const { return all_[index]; }

 private:
  std::deque<TrueTouch> all_;
  std::array<std::optional<std::size_t>, 2 * (world::max_robot_number + 1)> open_{};
  std::deque<Contact> recent_;
  std::vector<Contact> fresh_;
};

}  // namespace judge
