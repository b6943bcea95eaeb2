#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "autoref/referee/call.h"
#include "autoref/referee/override.h"
#include "autoref/referee/setup.h"
#include "sim/world/detection.h"
#include "sim/world/game_state.h"
#include "sim/world/referee_message.h"
#include "sim/world/tracked_frame.h"

namespace referee {

/// What the referee wants done after a tick.
struct Output {
  bool message_changed = false;  ///< something in the message other than its clocks
  /// [m] put the ball here, at rest. Present when the wish arises and again after `rules.reset_retry` for as
  /// long as the ball is not there; a repeated wish does not restart the host's own waiting times.
  std::optional<world::Vector2d> ball_reset;
  std::span<const Call> calls;  ///< made in this tick, in order; valid until the next update
  bool finished = false;        ///< the game is over (stage POST, HALT sent)
};

/// One transition of the automaton, for debugging and for `ssl-autoref`; includes those nobody notices.
struct TransitionRecord {
  world::Time time;
  std::string_view row;
  world::Location from;
  world::Location to;
};

/// The whole referee: tracker -> touch -> detectors -> automaton -> message and calls.
///
/// It has no clock but the frames' capture times, so the same detections give the same calls, live or from a
/// log. After `rules.vision_timeout` without a new frame it halts the game, and when frames are back it sends
/// STOP and the restart that was interrupted: calls of the row "vision".
class Referee {
 public:
  explicit Referee(Setup setup);
  ~Referee();
  Referee(Referee&&) noexcept;
  Referee& operator=(Referee&&) noexcept;

  /// Takes everything that arrived in one tick; nothing, or nothing new, changes nothing.
  ///
  /// @param clock  the receiver's clock, any steady one; without it, a vision that stopped is
  ///               noticed when it is back
  Output update(std::span<const world::Detection> detections,
                std::optional<world::Time> clock = std::nullopt);

  /// For those who have tracked frames already (tests, watching): the same without
  /// tracker and touch detection.
  Output update(const world::TrackedFrame& frame);

  /// The operator's word (R-8-7): done at once, reported as a call of the row "override" with the next
  /// update, and shown as the message's status until the referee's own next call.
  ///
  /// @return empty when it was done; else one sentence that says why not, and nothing has changed
  std::string overrule(const Override& wish);

  /// Teams' wishes, heard at the next update. A time-out waits for the next stoppage, and is forgotten when
  /// the team has none left; ending it also withdraws one that has not begun.
  void request_timeout(world::Team team);
  void end_timeout(world::Team team);
  void set_keeper(world::Team team, int number);

  const world::RefereeMessage& message() const;
  const world::GameState& state() const;
  const world::TrackedFrame& frame() const;
  /// Of the last update, in order.
  std::span<const TransitionRecord> transitions() const;
  /// How often the event loop had to be cut short; anything but 0 is a defect of the tables.
  int loop_defects() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace referee
