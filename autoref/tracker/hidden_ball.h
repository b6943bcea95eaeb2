#pragma once

#include <array>
#include <optional>
#include <span>

#include "autoref/tracker/ball_filter.h"
#include "sim/world/field.h"
#include "sim/world/tracked_frame.h"

namespace tracker {

/// Where a ball is that no camera sees, because robots have it or hide it.
///
/// A few hypotheses, each with a weight: the ball is free and lies or rolls, or a robot has it at its
/// dribbler. Hulls push it; a front that meets it may take it. What every frame without a ball says is used:
/// a hypothesis whose place is in view loses weight until only those are left that explain why nobody sees
/// it. What is published is the heaviest, until another is clearly heavier.
class HiddenBall {
 public:
  explicit HiddenBall(const world::Geometry& geometry);

  bool active() const { return count_ > 0; }
  void clear() { count_ = 0; }

  /// It was lost at `time`, moving as given.
  /// @param robots  foretold to `time`
  void start(const BallFilter::Motion& motion, world::Time time, std::span<const world::TrackedRobot> robots);
  /// Another frame without a ball.
  /// @param robots  foretold to `time`
  /// @pre active
  void advance(world::Time time, std::span<const world::TrackedRobot> robots);

  /// Where it most likely is.
  /// @pre active
  /// @param robots  foretold to `time`
  BallFilter::Motion best(world::Time time, std::span<const world::TrackedRobot> robots) const;
  /// The probability that it is wholly beyond the lines.
  /// @pre active
  /// @param robots  foretold to `time`
  double outside(world::Time time, std::span<const world::TrackedRobot> robots) const;
  /// The hypothesis nearest to a place; nothing when none is within `tolerance` [m].
  std::optional<BallFilter::Motion> nearest(const Vector2d& place, double tolerance, world::Time time,
                                            std::span<const world::TrackedRobot> robots) const;

  /// Which share of the ball the nearest camera sees, about: 0 behind a robot, 1 in view.
  double visible(const Vector2d& ball, std::span<const world::TrackedRobot> robots) const;
  /// The robot that hides a place from the camera nearest to it; null when it is in view.
  const world::TrackedRobot* hider(const Vector2d& ball, std::span<const world::TrackedRobot> robots) const;

  /// From a robot's hull, with its flat front, to the ball [m], negative inside, and the way out.
  struct Gap {
    double distance = 0;
    Vector2d out = Vector2d::Zero();  ///< unit vector, field frame
    bool at_front = false;
  };
  static Gap gap(const world::Field& field, const world::TrackedRobot& robot, const Vector2d& ball);

 private:
  struct Hypothesis {
    std::optional<world::RobotId> holder{};
    Vector2d place = Vector2d::Zero();     // [m]
    Vector2d local = Vector2d::Zero();     // [m] the same in the holder's frame
    Vector2d velocity = Vector2d::Zero();  // [m/s] of a free ball
    double weight = 0;
    std::optional<world::RobotId> hidden_by{};  // a free ball, in the last frame
    Vector2d beside = Vector2d::Zero();         // [m] its place in that robot's frame
  };
  static constexpr std::size_t most = 8;

  BallFilter::Motion motion(const Hypothesis& one, world::Time time,
                            std::span<const world::TrackedRobot> robots) const;
  void move_free(Hypothesis& one, double dt, std::span<const world::TrackedRobot> robots);
  void move_held(Hypothesis& one, std::span<const world::TrackedRobot> robots);
  void add(const Hypothesis& one);
  void hold(Hypothesis& from, const world::TrackedRobot& robot, const Vector2d& ball, double share);
  const Hypothesis* hypothesis_of(world::RobotId holder) const;

  world::Geometry geometry_;
  world::Field field_;
  double roll_;  // [m/s^2]
  std::array<Hypothesis, most> all_;
  std::size_t count_ = 0;
  std::size_t best_ = 0;
  world::Time time_;  // to which the free ones are advanced
};

}  // namespace tracker
