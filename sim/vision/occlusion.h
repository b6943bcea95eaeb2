#pragma once

#include <array>
#include <span>

#include "sim/truth/truth.h"
#include "sim/world/robot_specs.h"

namespace vision {

/// What robots leave of a ball in a camera's view.
struct BallView {
  double share = 1;  ///< visible share of the ball's disc
  /// [m] middle of what is visible, at the ball's distance
  world::Vector3d center = world::Vector3d::Zero();
};

/// Which part of the ball robots hide from a camera, in closed form.
///
/// All is drawn on the plane through the ball's centre across the line of sight, where the ball is a disc and
/// a robot, a prism with flat front standing on the carpet, a convex polygon: the far edges of its top and
/// the near edges of its bottom. The hidden area and its first moments are those of disc and polygon (Green's
/// theorem: chords and circular arcs); of several robots those of the union, by inclusion and exclusion.
/// A robot hides nothing when the plane that separates it from the ball (through its point nearest to the
/// ball, across the way there) has the camera on the ball's side: then the ball is in front.
///
/// Accuracy  exact for the prism, whose round side has 20 facets (0.5 mm off the cylinder at most).
class Occlusion {
 public:
  /// @param body  of every robot; its front nearer than its radius
  Occlusion(const world::RobotSpecs& body, double ball_radius);

  /// @pre the camera is higher than any robot and than the ball
  BallView view(const world::Vector3d& camera, const world::Vector3d& ball,
                std::span<const truth::Robot> robots) const;

 private:
  static constexpr int facets = 20;  // of the round side

  bool ball_in_front(const world::Vector3d& camera, const world::Vector3d& ball,
                     const truth::Robot& robot) const;

  double radius_, height_, front_;  // [m] of a robot
  double half_front_;               // [m] half the width of its front
  double ball_radius_;              // [m]
  std::array<world::Vector2d, facets + 1>
      outline_;  // [m] local, counter-clockwise, from one end of the front
};

}  // namespace vision
