#pragma once

#include <optional>

#include "experiments/judge/event.h"
#include "experiments/judge/true_touches.h"
#include "sim/world/geometry.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace judge {

/// Who touched the ball last before it left the field, in truth.
struct LastTouch {
  world::RobotId robot;
  world::Time time;  ///< of its last contact
  Kind kind{};
  bool chip = false;     ///< the ball was higher than a robot since
  bool crowded = false;  ///< robots of both teams within 150 mm of the ball then
  bool at_line = false;  ///< less than two ticks before the ball was out
  double impulse = 0;    ///< [N s] of the whole touch
  double alone = 1e9;    ///< [s] since the other team's last contact
  int lost = 0;  ///< [ticks] longest stretch in which no camera saw the ball, from the touch to the exit
};

/// Something that happened, or nearly.
struct TrueEvent {
  Event event{};
  world::Time time;
  std::optional<world::Time> until{};  ///< it lasted: a call in this time is none of nothing
  std::optional<world::Time> clear{};  ///< of what lasted: since then a band beyond its limit
  double margin = 0;  ///< how far beyond its limit, in bands; negative: it stayed within, by so much
  double value = 0;   ///< what was measured [SI]
  std::optional<world::RobotId> by{};
  world::Vector2d place = world::Vector2d::Zero();  ///< [m]
  bool ambiguous = false;  ///< in truth: robots of both teams touched within one tick
  bool over_goal = false;  ///< an exit: over the crossbar
  bool late = false;       ///< after the acting referee's whistle: counts only where somebody called it
  std::optional<LastTouch> last{};

  bool happened() const { return margin > 0; }
  /// So near to the limit that it stands in a row of its own.
  bool close() const { return margin > -1 && margin < 1; }
};

/// A limit that was missed by more than this many bands is not even a near miss.
inline constexpr double near_bands = 2;

}  // namespace judge
