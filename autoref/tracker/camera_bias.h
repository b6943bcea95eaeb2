#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "autoref/tracker/params.h"
#include "sim/world/geometry.h"
#include "sim/world/time.h"

namespace tracker {

using world::Vector2d;

/// Where each camera sees things beside where the cameras together see them: a constant offset per camera,
/// estimated from things that two cameras see.
///
/// One Kalman filter for each axis, with common covariance. The state is every camera's offset, a measurement
/// the difference of two, so what all cameras have in common cannot be known: the offsets of cameras joined
/// by overlaps have mean zero, to rounding, because prior and drift are alike for all. A difference that
/// surprises counts as three sigmas. What is applied follows the estimate slowly, so that learning an offset
/// never looks like a motion.
/// Source  football.md 3.2 (slow state, prior 10 mm); Huber, "Robust estimation of a location parameter",
///         Annals of Mathematical Statistics, 1964.
class CameraBias {
 public:
  explicit CameraBias(const Params& params);

  /// One thing at one instant, seen by two cameras. Cameras beyond the sixteenth are not corrected.
  /// @param difference  [m] what `camera` says less what `other` says
  /// @param variance    [m^2] of the difference per axis, without the cameras' local errors
  void compare(int camera, int other, const Vector2d& difference, double variance, world::Time time);

  /// Moves what is applied towards the estimate; call once for every frame.
  void advance();

  /// What to subtract from this camera's positions [m].
  Vector2d applied(int camera) const;
  /// The estimate itself [m].
  Vector2d estimate(int camera) const;

  void reset();

 private:
  static constexpr std::size_t most = 16;
  struct Offset {
    int camera = 0;
    Vector2d estimate = Vector2d::Zero();  // [m]
    Vector2d applied = Vector2d::Zero();   // [m]
  };
  const Offset* find(int camera) const;
  std::size_t index_of(int camera);  // `most` when there is no room
  double& cov(std::size_t i, std::size_t j) { return covariance_[i * most + j]; }

  double prior_, drift_, local_;  // [m^2], [m^2/s], [m^2]
  double alone_;                  // [m^2] variance of a camera that was never compared
  double largest_;                // [m]
  bool on_;
  std::vector<Offset> offsets_;
  std::array<double, most * most> covariance_{};  // [m^2]
  world::Time last_;
};

}  // namespace tracker
