#pragma once

#include <array>

#include "sim/world/geometry.h"
#include "sim/world/robot_specs.h"

namespace skills {

using world::Vector2d;

/// What a motion may use.
struct Limits {
  double speed = 3;         ///< [m/s] or [rad/s]
  double acceleration = 3;  ///< speeding up
  double brake = 6;         ///< slowing down
};

/// A robot's own limits for driving, times a share kept in reserve for corrections.
///
/// 0.95: noise and the latency's remainder would otherwise ask for more than there is (ours).
Limits driving_limits(const world::RobotSpecs& specs, double share = 0.95);
Limits turning_limits(const world::RobotSpecs& specs, double share = 0.9);

/// The fastest motion along one axis from `speed` now to rest at `distance`: at most one reversal, then
/// accelerate, cruise, brake.
///
/// Source  reference "football", 2.2, generalised to a brake stronger than the acceleration. The top speed is
///         v^2 = (2 a b d + b v0^2) / (a + b).
class Profile {
 public:
  Profile() = default;
  Profile(double distance, double speed, const Limits& limits);

  double duration() const;
  double position(double time) const;  ///< from the start [m]; the end is `distance`
  double velocity(double time) const;

 private:
  struct Phase {
    double duration = 0;
    double acceleration = 0;
  };
  double speed_ = 0;
  std::array<Phase, 5> phases_{};
};

/// Duration of that motion alone [s]; cheaper than the profile.
double time_to_rest(double distance, double speed, const Limits& limits);

/// Motion in the plane with both axes arriving together; the axes share the limits as cos and sin of an angle
/// found by bisection.
///
/// Accuracy  |T_x - T_y| below 2 % of T after 7 halvings; each axis ends exactly at the target.
/// Source    reference "football", 2.2. The axes lie along and across the line to the target,
///           so that a robot at rest drives straight.
class Drive {
 public:
  /// @param cell  in: where to look first, as that of the tick before; out: what was found. The same motion
  ///              with every guess, in fewer steps with a good one; only when the robot is much faster than
  ///              `limits` (STOP began) there may be two splits, and a guess can choose.
  Drive(const Vector2d& to_target, const Vector2d& velocity, const Limits& limits, int* cell = nullptr);

  double duration() const { return std::max(along_.duration(), across_.duration()); }
  Vector2d position(double time) const;  ///< from the start [m]
  Vector2d velocity(double time) const;

 private:
  Vector2d axis_ = Vector2d::UnitX();
  Profile along_;
  Profile across_;
};

/// The velocity of the next tick on the way to a point beside a line: across the line with 0.85 of the
/// limits, along it with the rest (0.52), each axis by itself, so that getting onto the line never waits.
///
/// @param along  unit vector of the line
/// Source        reference "football", 2.2 (favour the cross-track axis); the shares are ours
Vector2d cross_track_velocity(const Vector2d& to_target, const Vector2d& velocity, const Vector2d& along,
                              const Limits& limits);
/// The share of the limits that is left along the line: 0.85^2 + 0.52^2 < 1.
inline constexpr double along_track_share = 0.52;

/// Time to reach a point and rest there [s], by the line to it alone: for comparing robots, not for driving.
///
/// Accuracy  never more than the true time when the velocity points along the line; the sideways velocity is
///           charged with the time to brake it.
double travel_time(const Vector2d& to_target, const Vector2d& velocity, const Limits& limits);

/// Time to come within `reach` of a point, passing it at any speed [s].
double time_to_touch(const Vector2d& to_target, const Vector2d& velocity, const Limits& limits, double reach);

}  // namespace skills
