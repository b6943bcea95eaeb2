#pragma once

#include <optional>

#include "autoref/detectors/detector.h"
#include "sim/world/rules/rule_set.h"

namespace detectors {

/// POSSIBLE_GOAL: the whole ball crossed a goal line between the posts and under the bar.
///
/// Rule    laws of 2015, Law 10. Whether the goal counts is the automaton's business.
/// Guard   |x| - half length - ball radius  [m], rising, with the crossing between the posts.
/// Certain when the ball stayed in the goal for 9 frames, or came back out of it after 2 frames inside,
///         or has not been seen for half a second after it went in. Not a goal when it was seen behind
///         the back wall or beside the goal for 3 frames in a row (it flew over), or higher than the bar.
///         These numbers are ours: a chip of 2.5 m/s needs 6 frames to pass over a goal, and a filter may
///         run through the back wall for a frame or two.
///         A ball that met a post and is then inside the goal went in through the mouth.
///         A ball that comes out and goes in again within half a second is the same goal.
/// Resets  when the ball is in the field again.
class Goal final : public Detector {
 public:
  explicit Goal(const world::RuleSet& rules) : field_(rules.field) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    last_in_front_.reset();
    entry_.reset();
    told_.reset();
  }

 private:
  struct Sample {
    world::Time time;
    world::Vector2d ball;
  };
  struct Entry {
    world::Time time;       // when the line was crossed
    world::Vector2d place;  // [m] where
    int frames = 0;         // observed since
    int inside = 0;         // of them in the goal
    int behind = 0;         // the last ones in a row behind or beside it
    bool decided = false;   // reported, or found to be no goal
  };

  double guard(const world::Vector2d& ball) const;
  void watch_for_entry(const world::TrackedFrame& frame, const world::Vector2d& ball);

  world::Field field_;
  std::optional<Sample> last_in_front_;
  std::optional<Entry> entry_;
  std::optional<world::Time> told_;  // the last goal
};

}  // namespace detectors
