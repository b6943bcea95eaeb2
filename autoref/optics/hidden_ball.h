#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sim/world/detection.h"
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

/// Takes balls back to where they are: SSL-Vision reports the middle of the part that a camera sees, and
/// robots of 15 cm hide a part of a ball that lies up to a few decimetres behind them. At half a ball that is
/// 9 mm.
///
/// The robots' places in the same image and the camera's place give the shadow of each hull in which the ball
/// lies; its edge is taken as straight. Without cameras in the geometry nothing is changed.
/// Source  geometry; the shift against the exact occlusion of `sim/vision` in tests.
class HiddenBall {
 public:
  explicit HiddenBall(const world::Geometry& geometry) : field_(geometry.field), cameras_(geometry.cameras) {}

  WholeBall whole(const Vector2d& seen, const world::Detection& image) const;

 private:
  world::Field field_;
  std::vector<world::Camera> cameras_;
};

}  // namespace optics
