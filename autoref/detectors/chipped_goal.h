#pragma once

#include <boost/container/static_vector.hpp>

#include "autoref/detectors/detector.h"
#include "autoref/detectors/goal.h"

namespace detectors {

/// CHIPPED_GOAL: a goal that does not count, because the ball was too high before.
///
/// Rule    laws of 2015, Law 12, indirect free kicks and decision 7: a robot made the ball's top rise
///         above 150 mm, and it went into the opponents' goal without having touched a team-mate of
///         that robot while below 150 mm, and without having rolled ("stopped bouncing"). A goal into
///         the robot's own goal counts, unless a touch of an opponent made the ball rise above 150 mm:
///         then the opponent is to blame.
/// Guard   that of the goal, in the same tick; the goal then does not count. A ball is high when
///         TrackedBall::position or Flight::highest says so and the filter became sure that it flew.
///         It rolls when it had no flight for chip_rolling, or for landed_rolling if its
///         flight ended on the ground.
/// Blames  who touched the ball last before it was high, but nobody above whom it passed.
/// Limits  as good as the filter's heights; with RuleSet::chip_model off no ball is ever high.
class ChippedGoal final : public Detector {
 public:
  explicit ChippedGoal(const world::RuleSet& rules)
      : field_(rules.field), height_(rules.chip_height), rolling_(rules.chip_rolling), goal_(rules) {}

  Events update(const world::TrackedFrame& frame, const world::GameState& state) override;
  void reset() override {
    chips_ = {};
    grounded_since_.reset();
    touches_.clear();
    last_height_ = 0;
    before_.reset();
    goal_.reset();
  }

 private:
  struct Chip {
    world::RobotId by;
    world::Vector2d kick;                 // [m]
    double highest = 0;                   // [m] top of the ball
    std::optional<world::Time> kicked{};  // the flight that it began
    bool sure = false;                    // that there was a flight
  };

  void watch_height(const world::TrackedFrame& frame);
  void watch_certainty(const world::TrackedBall& ball);
  void watch_touches(const world::TrackedFrame& frame, const world::GameState& state);
  const world::Touch* toucher(const world::Flight& flight) const;

  world::Field field_;
  double height_;
  world::Duration rolling_;
  Goal goal_;
  world::PerTeam<std::optional<Chip>> chips_;                 // by the team that made the ball fly
  boost::container::static_vector<world::Touch, 4> touches_;  // the last of each robot, oldest first
  std::optional<world::Time> grounded_since_;                 // first frame in a row without flight
  double last_height_ = 0;                                    // [m] of the ball in its last flight
  std::optional<std::pair<world::Time, double>> before_;      // and of the frame before this, 0 on the ground
};

}  // namespace detectors
