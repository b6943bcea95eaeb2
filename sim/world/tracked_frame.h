#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sim/world/geometry.h"
#include "sim/world/robot_id.h"
#include "sim/world/time.h"

namespace world {

/// A ball in the air, as the filter understands it.
struct Flight {
  Time kicked;                                  ///< when it left the ground
  Vector2d from = Vector2d::Zero();             ///< [m] and where
  Vector3d launch_velocity = Vector3d::Zero();  ///< [m/s]
  double highest = 0;                           ///< [m] greatest height of the ball's lowest point so far
  struct Struck {
    RobotId robot;
    Time time;
  };
  std::optional<Struck> struck{};  ///< the robot it hit last in the air: its side or its cover
};

/// Positions and velocities are in the field frame, SI units, unless a name ends in `_local`.
struct TrackedBall {
  Vector3d position = Vector3d::Zero();  ///< [m] centre; z is the height above its resting place
  Vector3d velocity = Vector3d::Zero();  ///< [m/s]
  bool observed = false;                 ///< some camera saw it in this frame
  Duration unseen{};                     ///< time since a camera saw it last
  double sigma = 0;                      ///< [m] standard deviation of the position, larger of both axes
  double outside = 0;                    ///< of a hidden ball: probability that it is wholly beyond the lines
  double airborne = 0;                   ///< probability that it is in the air now
  bool may_fly = false;                  ///< kicked so recently that this cannot be said yet
  std::optional<Flight>
      flight{};  ///< while airborne is above a half; position and velocity are then in space
};

struct TrackedRobot {
  RobotId id;
  Vector2d position = Vector2d::Zero();  ///< [m] centre
  double orientation = 0;                ///< [rad] in (-pi, pi], 0 = field x, counter-clockwise
  Vector2d velocity = Vector2d::Zero();  ///< [m/s]
  double angular_velocity = 0;           ///< [rad/s]
  bool observed = false;                 ///< some camera saw it in this frame
  bool ball_in_reach = false;            ///< geometry only: the ball is at the dribbler
};

/// A robot touched the ball, as far as anyone can tell from detections.
struct Touch {
  RobotId robot;
  Time time;  ///< of the contact; up to a few frames before the frame that reports it
  Vector2d position = Vector2d::Zero();  ///< [m] ball at that time
  double probability = 1;                ///< that this robot was the last to touch it
  std::optional<RobotId> rival{};        ///< who else it may have been, the most likely one
};

/// What the tracker believes about one instant of the match.
struct TrackedFrame {
  Time time;
  std::optional<TrackedBall> ball;   ///< nothing until a ball was seen, and again when it is lost for long
  std::vector<TrackedRobot> robots;  ///< sorted by id
  std::vector<Touch> touches;  ///< found in this frame; empty for teams, which do not run touch detection
};

/// The robot of that id, or null.
inline const TrackedRobot* find_robot(const TrackedFrame& frame, RobotId id) {
  for (const TrackedRobot& robot : frame.robots) {
    if (robot.id == id) return &robot;
  }
  return nullptr;
}

}  // namespace world
