#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace judge {

/// What can be called and can happen: the referee's catalogue, with the offences of a kick as events of their
/// own and both lines of an exit as one.
enum class Event : std::uint8_t {
  Exit,  ///< the whole ball left the field, not into a goal
  Goal,  ///< it entered a goal and that counts
  ChippedGoal,
  AimlessKick,
  BallTooFast,
  DribbledTooFar,
  DoubleTouch,
  Collision,
  KeeperTouched,
  DefenderInArea,
  AttackerInArea,
  KeeperHeldBall,
  NoProgress,
  TooManyRobots,
  RobotLeftField,
  KickTaken,
  OpponentNearBall,  ///< at the kick
  AttackerNearArea,  ///< at the kick
  WrongHalf,         ///< at the kickoff
  RobotsSettled,
  TooFastInStop,
  TooNearInStop,
  InterferedPlacement
};
inline constexpr std::size_t event_count = 23;
constexpr std::array<Event, event_count> all_events() {
  std::array<Event, event_count> all{};
  for (std::size_t n = 0; n < event_count; ++n) all[n] = static_cast<Event>(n);
  return all;
}

std::string_view name(Event event);                       ///< "ball left field"
std::optional<Event> event_named(std::string_view name);  ///< nothing: there is none of that name
/// The detector of the referee's catalogue that calls it.
std::string_view detector_of(Event event);

/// How near to its limit an event must be so that nobody can be blamed for calling it otherwise. Margins are
/// counted in these: 1 is as far beyond the limit as the band is wide.
///
/// The lengths are the issue's; a speed is told from a length covered in 0.2 s (twelve frames),
/// a time by as much. Ours.
struct Bands {
  double length = 0.04;  ///< [m]
  double speed = 0.2;    ///< [m/s]
  double time = 0.2;     ///< [s]
};
/// Of a realism preset: harsh is half as wide again.
Bands bands_of(std::string_view preset);

}  // namespace judge
