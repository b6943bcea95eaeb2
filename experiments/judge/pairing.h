#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/judge/shadow.h"
#include "experiments/judge/true_event.h"

namespace judge {

/// What became of one true event or one call.
enum class Result : std::uint8_t { Found, Missed, Extra };
std::string_view name(Result result);

/// A true event and the call of it, or one of them alone.
struct Case {
  std::string shadow;
  Event event{};
  Result result{};
  std::optional<TrueEvent> truth{};
  std::optional<Call> call{};
  bool chip = false;     ///< an extra call while the ball was in the air
  std::string remark{};  ///< of an extra call: what else was true

  /// So near to the limit that nobody can be blamed.
  bool close() const { return truth && truth->close(); }
  bool ambiguous() const { return truth && truth->ambiguous; }
  /// Called only when what lasted had been clear for longer than the window: neither found nor extra.
  bool late() const;
  bool team_is_right() const {
    return truth && truth->last && call && call->last && call->last->robot.team == truth->last->robot.team;
  }
  world::Time time() const { return truth ? truth->time : call->time; }
};

/// Greatest distance in time between an event and the call of it [s]: the paper's.
inline constexpr double match_window = 0.3;

/// One to one within the window; an event that lasts may be called as long as it does. Preferred are, in this
/// order: clear events before those close to their limit, and these before near misses; calls of the right
/// robot; the nearest in time.
///
/// Calls that are left are extra and events that are left were missed, but neither counts after the acting
/// referee's whistle. Near misses that are left are no cases.
std::vector<Case> pair(const std::string& shadow, std::vector<TrueEvent> truth,
                       const std::vector<Call>& calls, const world::RuleSet& rules);

}  // namespace judge
