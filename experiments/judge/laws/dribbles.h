#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/judge/laws/moment.h"

namespace judge {

/// A robot dribbled too far (Law 12, decision 5): straight from where contact began, until ball and robot
/// are visibly apart (20 mm, ours: the law says no number).
///
/// Margin  the distance beyond the limit. A dribble goes on for half a second after the referee has stopped
///         play, or its margin would only say how quick the referee was.
class Dribbles {
 public:
  void watch(const Moment& moment, std::vector<TrueEvent>& out);

 private:
  struct Dribble {
    world::Vector2d start;  // [m]
    double farthest = 0;    // [m]
    std::optional<world::Time> passed{};
    world::Vector2d place = world::Vector2d::Zero();
  };
  void finish(const Moment& moment, std::size_t robot, std::vector<TrueEvent>& out);

  std::array<std::optional<Dribble>, robot_slots> dribbles_;
  std::array<world::RobotId, robot_slots> ids_;
  std::optional<world::Time> stopped_;
};

}  // namespace judge
