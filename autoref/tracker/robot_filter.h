#pragma once

#include <algorithm>
#include <optional>

#include "autoref/tracker/params.h"
#include "sim/world/geometry.h"

namespace tracker {

using world::Vector2d;

/// Gaussian belief about one coordinate and its rate, driven by white acceleration.
///
/// Unit of the coordinate: metres or radians (u).
struct Axis {
  double x = 0;                   ///< [u]
  double v = 0;                   ///< [u/s]
  double xx = 0, xv = 0, vv = 0;  ///< covariance

  /// Lets time pass.
  /// @param q spectral density of the acceleration [u^2/s^3]
  void predict(double dt, double q) {
    x += v * dt;
    xx += dt * (2 * xv + dt * vv) + q * dt * dt * dt / 3;
    xv += dt * vv + q * dt * dt / 2;
    vv += q * dt;
  }

  /// Takes in a measurement that differs from `x` by `innovation`; `r` is its variance [u^2].
  void update(double innovation, double r) {
    const double s = xx + r;
    const double kx = xx / s;
    const double kv = xv / s;
    x += kx * innovation;
    v += kv * innovation;
    vv -= kv * xv;
    xv *= 1 - kx;
    xx *= 1 - kx;
  }
};

/// A robot as three independent axes: x, y and heading.
class RobotFilter {
 public:
  explicit RobotFilter(const Params& params);

  /// Starts anew from one sighting: velocities unknown within `speed_sigma` [m/s] and a proportionate turn.
  void start(const Vector2d& position, std::optional<double> heading, const Vector2d& velocity,
             double speed_sigma);

  void predict(double dt);
  /// Tells where its velocity is heading [m/s]: it changes as fast as a robot can, within `dt` [s] that was
  /// just predicted.
  void drive(const Vector2d& wanted, double dt);
  /// Normalised innovation squared of a position (chi-square, 2 degrees of freedom).
  double nis(const Vector2d& measured) const;
  /// The same of a heading (1 degree of freedom).
  double heading_nis(double measured) const;
  void update(const Vector2d& measured, std::optional<double> heading);
  /// After a collision: the measured position is believed, the velocity may have become any other.
  void collide(const Vector2d& measured, double speed_sigma);
  /// The same for the heading.
  void spin(double measured, double turn_sigma);

  Vector2d position() const { return {x_.x, y_.x}; }
  Vector2d velocity() const { return {x_.v, y_.v}; }
  double velocity_variance() const { return std::max(x_.vv, y_.vv); }  ///< [m^2/s^2]
  double heading() const { return heading_.x; }                        ///< [rad] in (-pi, pi]
  double angular_velocity() const { return heading_.v; }               ///< [rad/s]

 private:
  double q_, q_turn_, r_, r_heading_;
  Axis x_, y_, heading_;
};

}  // namespace tracker
