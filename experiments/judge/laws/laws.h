#pragma once

#include <optional>
#include <vector>

#include "experiments/judge/laws/areas.h"
#include "experiments/judge/laws/ball_speed.h"
#include "experiments/judge/laws/contacts.h"
#include "experiments/judge/laws/dribbles.h"
#include "experiments/judge/laws/exits.h"
#include "experiments/judge/laws/kicks.h"
#include "experiments/judge/laws/progress.h"
#include "experiments/judge/laws/robots.h"
#include "experiments/judge/laws/settling.h"
#include "experiments/judge/laws/stops.h"

namespace judge {

/// All laws over one game: exact frames in, true events out. Knows nothing of detections or detectors.
class Laws {
 public:
  Laws(const world::RuleSet& rules, const Bands& bands) : rules_(rules), bands_(bands) {}

  /// The next tick.
  ///
  /// Laws of play are watched for another 0.3 s after the referee has stopped it, because it may have been
  /// early. Their events are then `late`, and so is what happens after the ball has truly left the field.
  ///
  /// @param state      of the acting referee as this tick began for it
  /// @param ball_seen  by some camera
  void watch(const truth::Frame& frame, const world::GameState& state, bool ball_seen);

  /// The game is over: what goes on then is told as it stands.
  void finish();

  /// What has become certain so far; events come when their margin is known, not in order of time.
  const std::vector<TrueEvent>& events() const { return events_; }
  const TrueTouches& touches() const { return touches_; }
  bool moved_by_hand() const { return by_hand_; }

 private:
  /// It refers to its arguments.
  Moment at(const truth::Frame& now, const world::GameState& state, bool entered, bool ball_seen) const;
  void watch_play(const Moment& play);
  void mark_late(std::size_t first, const world::GameState& state);

  world::RuleSet rules_;
  Bands bands_;
  TrueTouches touches_;
  std::optional<truth::Frame> before_;
  world::Location location_{};
  world::Time location_time_;
  bool by_hand_ = false;
  world::GameState state_;                // at the last tick
  std::optional<world::GameState> play_;  // the state in which play was stopped, while it is watched on
  std::vector<TrueEvent> events_;

  Exits exits_;
  BallSpeed ball_speed_;
  Dribbles dribbles_;
  Kicks kicks_;
  Areas areas_;
  KeeperHolds keeper_holds_;
  Contacts contacts_;
  Stops stops_;
  RobotsOff robots_;
  Progress progress_;
  Settling settling_;
};

}  // namespace judge
