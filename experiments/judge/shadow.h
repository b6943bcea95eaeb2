#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "autoref/detectors/catalogue.h"
#include "experiments/judge/event.h"
#include "experiments/judge/eyes.h"
#include "experiments/judge/timeline.h"
#include "sim/world/game_event.h"

namespace judge {

/// What a shadow says happened.
struct Call {
  Event event{};
  world::Time time;      ///< when it happened, as called
  world::Time reported;  ///< time of the frame in which it was
  std::optional<world::RobotId> by{};
  bool late = false;  ///< after the acting referee's whistle: counts only where it was true
  world::Vector2d place = world::Vector2d::Zero();       ///< [m]
  std::optional<world::Touch> last{};                    ///< of exits: who touched the ball last
  std::vector<std::optional<world::Touch>> witnesses{};  ///< of exits: what each Witness says
};

/// How long a shadow may go on in a state that the acting referee has left: the widest window of matching and
/// a tenth, and less than the 0.5 s after which the ball may be put elsewhere.
inline constexpr world::Duration linger = std::chrono::milliseconds{400};

/// The detectors of a rule set beside the referee that runs the game: it sees the same world, and in every
/// tick its game state is the acting referee's, but for who touched the ball last, which is its own to say.
///
/// Each location has a set of detectors of its own, which goes on for `linger` after the acting referee has
/// left the location: it may be slower, or see sooner what was coming. One that joins a game in play begins
/// with the last touch of the acting referee.
class Shadow {
 public:
  Shadow(std::string name, const world::Geometry& geometry, world::RuleSet rules);

  const std::string& name() const { return name_; }
  const world::RuleSet& rules() const { return rules_; }

  /// Images of this tick: own filter, own touch detection.
  /// @return whether there was a new frame
  bool see(std::span<const world::Detection> images, const Timeline& timeline, bool by_hand);
  /// A frame with its touches, of somebody else's filter.
  void see(const world::TrackedFrame& frame, const world::GameState& state, bool by_hand);

  /// Of the last frame.
  std::span<Call> fresh() { return {calls_.data() + first_fresh_, calls_.size() - first_fresh_}; }
  const std::vector<Call>& calls() const { return calls_; }
  /// The ball's place in the last frame that showed it; for the reader of a failing case.
  const world::TrackedFrame& frame() const { return eyes_.frame(); }

 private:
  struct Part {  // of one location
    std::optional<detectors::Detectors> detectors;
    world::GameState state;
    bool running = false;
    std::optional<world::Time> left;
  };
  void follow(Part& part, world::Location location, const world::GameState& state);
  void take(const world::GameEvent& event, const world::TrackedFrame& frame, const Part& part, bool chipped);

  std::string name_;
  world::RuleSet rules_;
  Eyes eyes_;
  world::Time last_frame_;
  bool joined_ = false;        // has seen a frame
  std::array<Part, 3> parts_;  // GameOn, Setup, GameOff
  std::optional<world::Touch> last_touch_;
  std::vector<Call> calls_;
  std::size_t first_fresh_ = 0;
};

}  // namespace judge
