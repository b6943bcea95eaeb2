#pragma once

#include "sim/world/field.h"

namespace optics {

using world::Vector2d;

/// The middle of the visible part of a disc of which a straight edge hides the rest, from the disc's middle
/// and away from the edge.
///
/// @param u  from the edge to the disc's middle, in radii: 1 touches it from outside, -1 hides all of it
/// @return radii
double shift_of_visible(double u);

/// The u at which the middle of the visible part is seen `m` radii from the edge: u + shift_of_visible(u).
/// It grows from 0 at u = -1 to 1 at u = 1; beyond, the nearest is returned.
double uncovered(double m);

/// A ball as it must lie, when a robot hides a part of it from the camera.
struct WholeBall {
  Vector2d position = Vector2d::Zero();  ///< [m]
  double shift = 0;                      ///< [m] how far off its visible part was seen
  double slope = 1;                      ///< change of what is seen for one of the ball, across the edge
};

/// Takes a ball back to where it is: SSL-Vision reports the middle of the part that a camera sees, and robots
/// of 15 cm hide a part of a ball that lies up to a few decimetres behind them. At half a ball that is 9 mm.
///
/// The place of robot and camera give the shadow of the hull in which the ball lies, its hull drawn out away
/// from the camera's foot; its edge is taken as straight. Of several robots the one that hides most counts.
/// Source  geometry; against the exact occlusion of `sim/vision` in tests.
class PartlyHidden {
 public:
  /// @param seen  [m] of the ball on the ground
  PartlyHidden(const world::Field& field, const world::Camera& camera, const Vector2d& seen);
  /// A robot somewhere; those far away cost nothing.
  void beside(const Vector2d& robot, double orientation);
  WholeBall whole() const;

 private:
  const world::Field& field_;
  Vector2d seen_, foot_;
  double stretch_, reach_;  // of the shadow's length to the way from the foot; [m]
  double least_;            // [m] from the edge of the nearest shadow, negative inside
  Vector2d out_ = Vector2d::Zero();
  bool above_ = false;
};

}  // namespace optics
