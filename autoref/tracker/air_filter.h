#pragma once

#include <Eigen/Core>

#include "sim/world/geometry.h"

namespace tracker {

using world::Vector2d;
using world::Vector3d;

/// Gaussian belief about a ball in the air: position and velocity in space, from where
/// cameras see it on the ground.
///
/// A camera at c, H above the ball's resting place, shows a ball at p and height z at the ground point g:
///
///   p + z (g - c) / H = g
///
/// This is linear in what is not known, so this is a plain Kalman filter. Where the ball comes down it
/// bounces and goes on.
///
/// Source  football.md 3.3 (projection, bounces); gravity 9.81 m/s^2; the bounce's Jacobian by the usual rule
///         for a jump at an uncertain instant.
class AirFilter {
 public:
  /// A ball on the ground at `from`, known to `sigma` [m], that leaves it now with any
  /// velocity a kicker can give.
  AirFilter(const Vector2d& from, double sigma);
  /// A ball in the air at `place` [m], z known to `sigma` [m], with any velocity.
  AirFilter(const Vector3d& place, double sigma);

  /// Lets time pass.
  /// @pre dt >= 0 [s]
  void predict(double dt);
  /// Something struck the ball where it is: any velocity along the ground, about the same rise.
  void strike();
  /// The ball comes down on something flat `height` above the ground [m], and bounces there.
  void bounce_on(double height);

  struct Fit {
    double nis = 0;      ///< chi-square with 2 degrees of freedom
    double log_det = 0;  ///< of the innovation's covariance in units of the measurement variance
  };
  /// Takes in a place on the ground.
  /// @param camera [m]
  /// @param r [m^2] variance per axis
  Fit update(const Vector2d& seen, const Vector3d& camera, double r);
  /// What `update` would find, leaving the filter as it is.
  double nis(const Vector2d& seen, const Vector3d& camera, double r) const;
  /// Where that camera would see it on the ground [m].
  Vector2d seen_from(const Vector3d& camera) const;

  Vector3d position() const { return {x_[0], x_[2], x_[4]}; }  ///< [m] z: of the lowest point
  Vector3d velocity() const { return {x_[1], x_[3], x_[5]}; }  ///< [m/s]
  double sigma() const;                                        ///< [m] of x and y, the larger
  int bounces() const { return bounces_; }
  bool rolls() const { return rolls_; }  ///< its hops became too low to count

 private:
  void fly(double dt);
  void bounce();

  Eigen::Matrix<double, 6, 1> x_;  // x, its speed, y, its speed, z, its speed
  Eigen::Matrix<double, 6, 6> p_;
  int bounces_ = 0;
  bool rolls_ = false;
};

}  // namespace tracker
