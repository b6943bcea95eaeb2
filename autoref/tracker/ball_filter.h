#pragma once

#include <array>

#include "autoref/tracker/ball_ekf.h"
#include "autoref/tracker/params.h"
#include "sim/world/field.h"

namespace tracker {

/// A ball that slides, rolls, or is driven by something unseen: one extended Kalman filter for each, weighted
/// by how well it foretells the measurements.
///
/// Interacting multiple models: before every step the three beliefs are mixed by the chances of a change of
/// phase, afterwards each is weighted by its likelihood. `erratic` is the collision covariance of
/// football.md 3.1 and carries dribbled, pushed and flying balls.
/// Source  Bar-Shalom, Li, Kirubarajan, "Estimation with Applications to Tracking and
///         Navigation", 2001, Sec. 11.6.6.
class BallFilter {
 public:
  enum Phase { Slide, Roll, Erratic };
  static constexpr int phases = 3;

  BallFilter(const world::Geometry& geometry, const Params& params);

  /// Starts anew: position from one measurement, velocity known to `velocity_sigma` [m/s].
  void start(const Vector2d& position, const Vector2d& velocity, double velocity_sigma);

  /// Lets time pass.
  /// @param dt [s], >= 0
  /// @param near_robot  a robot may be touching the ball
  void predict(double dt, bool near_robot);

  /// The next measurements are so much [m] less certain than others; 0: as certain.
  void doubt(double sigma) { r_ = measurement_variance_ + sigma * sigma; }

  /// Normalised innovation squared of a measurement, by the phase that expects it best; chi-square with
  /// 2 degrees of freedom when that phase is right.
  double best_nis(const Vector2d& measured) const;
  /// The same for the mixture of all phases, as one Gaussian.
  double nis(const Vector2d& measured) const;

  void update(const Vector2d& measured);

  struct Motion {
    Vector2d position = Vector2d::Zero();  ///< [m]
    Vector2d velocity = Vector2d::Zero();  ///< [m/s]
    double sigma = 0;                      ///< [m] of the position, larger of both axes
  };
  /// Where the ball will be if nothing touches it; leaves the filter as it is. A sliding ball is taken to
  /// have just been kicked: it slides to the switch ratio of its present speed, then rolls.
  Motion foretell(double dt) const;

  Vector2d position() const;         ///< [m] mean of the mixture
  Vector2d velocity() const;         ///< [m/s]
  double velocity_variance() const;  ///< [m^2/s^2] of the mixture, larger of both axes
  double weight(Phase phase) const { return weights_[phase]; }

 private:
  void mix(double dt, bool near_robot);

  std::array<BallModel, phases> models_;
  double measurement_variance_;  // [m^2]
  double r_;                     // [m^2] of the next measurement
  double switch_ratio_;          // rolling begins at this share of the kick's speed
  std::array<BallEkf, phases> beliefs_;
  std::array<double, phases> weights_{};
};

}  // namespace tracker
