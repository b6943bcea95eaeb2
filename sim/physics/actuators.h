#pragma once

#include <cstdint>
#include <string>

#include "sim/physics/params.h"
#include "sim/world/robot_id.h"

namespace physics {

/// How far one kick misses what was asked of it.
struct KickError {
  double direction = 0;     ///< [rad] counter-clockwise
  double speed_factor = 1;  ///< of the commanded speed
  double chip_angle = 0;    ///< [rad] added to a chip's elevation
  bool misfires = false;    ///< the plunger does not reach the ball
};

/// One robot's actuators in one game: how far each of its kicks, each of its captures and its drive miss.
///
/// A pure function of match seed, robot and the number of the kick or capture: nothing to be stored, and no
/// draw shifts another. Gaussians end at 3 standard deviations, which takes 0.3 % off their width.
class Actuators {
 public:
  /// The stream is named "actuators <team> <number>".
  Actuators(const ActuatorErrors& errors, world::RobotId id, std::uint64_t seed);

  double speed_factor() const { return speed_factor_; }                ///< of the velocity asked for
  double acceleration_factor() const { return acceleration_factor_; }  ///< of acceleration and braking
  double heading_drift() const { return heading_drift_; }              ///< [rad/m] counter-clockwise

  /// @param number  of this robot's kicks in this game, from 0
  KickError kick(int number) const;

  /// Factor on the dribbler's grip during one capture of the ball.
  /// @param number  of this robot's captures in this game, from 0
  double grip_factor(int number) const;

 private:
  ActuatorErrors errors_;
  std::uint64_t seed_ = 0;
  double speed_factor_ = 1;
  double acceleration_factor_ = 1;
  double heading_drift_ = 0;
};

}  // namespace physics
