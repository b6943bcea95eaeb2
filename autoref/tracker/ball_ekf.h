#pragma once

#include <Eigen/Core>

#include "sim/world/geometry.h"

namespace tracker {

using Eigen::Matrix2d;
using world::Vector2d;

/// What a ball on the ground does by itself.
struct BallModel {
  double deceleration = 0;  ///< [m/s^2] against its motion, until it stands
  double noise = 0;         ///< [m^2/s^3] spectral density of the white acceleration
};

/// Gaussian belief about a ball on the ground: position and velocity, with covariance in 2 x 2 blocks.
///
/// Extended Kalman filter: v' = v - min(a dt, |v|) v/|v|, and p' by the mean of both velocities, which is
/// exact even when the ball comes to rest within the step. The Jacobian includes the friction.
///
/// Source  Simon, "Optimal State Estimation", 2006, Sec. 13.2; football.md 3.2.
struct BallEkf {
  Vector2d position = Vector2d::Zero();      ///< [m]
  Vector2d velocity = Vector2d::Zero();      ///< [m/s]
  Matrix2d position_cov = Matrix2d::Zero();  ///< [m^2]
  Matrix2d cross_cov = Matrix2d::Zero();     ///< [m^2/s] rows position, columns velocity
  Matrix2d velocity_cov = Matrix2d::Zero();  ///< [m^2/s^2]

  /// Lets time pass.
  /// @pre dt >= 0 [s]
  void predict(double dt, const BallModel& model);

  /// Takes in a measured position of variance `r` [m^2] per axis.
  /// @return the likelihood of the measurement [1/m^2]
  double update(const Vector2d& measured, double r);
};

/// Normalised square of an innovation of covariance `s`: chi-square with 2 degrees of freedom.
double normalised_square(const Vector2d& innovation, const Matrix2d& s);

}  // namespace tracker
