#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// A robot dribbled too far (Law 12, decision 5): straight from where contact began, until ball and robot
/// are visibly apart (20 mm, ours: the law says no number), or the ball is higher than a dribbler.
///
/// Margin  the distance beyond the limit. A dribble that was too far only if 60 mm do not count as apart yet
///         is close (-0.5), also if it then was within a band of the limit. A dribble is followed for half a
///         second after the referee has stopped play, or its margin would only say how quick the referee was.
class Dribbles {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Dribble {
    world::Vector2d start;  // [m]
    double farthest = 0;    // [m]
    std::optional<world::Time> passed{};
    std::optional<world::Time> close{};  // since when it is within a band of the limit, or beyond
    world::Vector2d place = world::Vector2d::Zero();
  };
  void watch(const Moment& moment, const truth::Robot& robot, double apart, std::optional<Dribble>& dribble);
  void finish(const Moment& moment, world::RobotId robot, std::vector<TrueEvent>& out);

  struct OfRobot {
    std::optional<Dribble> strict, lenient;  // as to what is apart
    bool strictly_too_far = false;           // during the lenient one
    bool strictly_close = false;
  };
  std::array<OfRobot, robot_slots> robots_;
  std::optional<world::Time> stopped_;
};

}  // namespace judge
