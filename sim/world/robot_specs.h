#pragma once

#include "sim/world/robot_id.h"

namespace world {

/// Body and limits of one robot, after any handicap. Limits along and across the heading bound an ellipse.
///
/// Values  2.5 kg, 3 m/s, 3 m/s^2, brake 6 m/s^2, 20 rad/s, 50 rad/s^2:
///         TIGERs' simulator parameters (reference "football", section 5), the same forward and sideways;
///         body from the laws (180 mm by 150 mm), front plate at 73 mm.
struct RobotSpecs {
  RobotId id;
  double radius = 0.09;                    ///< [m]
  double height = 0.15;                    ///< [m]
  double mass = 2.5;                       ///< [kg]
  double center_to_dribbler = 0.073;       ///< [m] centre to the flat front
  double dribbler_width = 0.07;            ///< [m]
  double max_speed = 3.0;                  ///< [m/s] forward and back
  double max_speed_sideways = 3.0;         ///< [m/s]
  double max_acceleration = 3.0;           ///< [m/s^2] speeding up, forward and back
  double max_acceleration_sideways = 3.0;  ///< [m/s^2] speeding up
  double max_brake = 6.0;                  ///< [m/s^2] slowing down, forward and back
  double max_brake_sideways = 6.0;         ///< [m/s^2] slowing down
  double max_angular_speed = 20.0;         ///< [rad/s]
  double max_angular_acceleration = 50.0;  ///< [rad/s^2] speeding up
  double max_angular_brake = 50.0;         ///< [rad/s^2] slowing down
  double max_kick_speed = 10.0;            ///< [m/s] flat; the 8 m/s of the laws is the referee's business
  double max_chip_speed = 6.0;             ///< [m/s] absolute
};

/// The same robot with speed and acceleration (braking too) multiplied by `factor`;
/// rotation stays (paper, Figure 8).
constexpr RobotSpecs slowed(RobotSpecs specs, double factor) {
  specs.max_speed *= factor;
  specs.max_speed_sideways *= factor;
  specs.max_acceleration *= factor;
  specs.max_acceleration_sideways *= factor;
  specs.max_brake *= factor;
  specs.max_brake_sideways *= factor;
  return specs;
}

}  // namespace world
