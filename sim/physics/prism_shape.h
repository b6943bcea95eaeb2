#pragma once

// Inside this folder only, as bullet_scene.h: shows Bullet's types.

#include <btBulletDynamicsCommon.h>

#include <array>
#include <span>

#include "sim/world/geometry.h"

namespace physics {

/// An upright prism as a convex hull that finds its farthest corner in a direction by looking near where it
/// must be, instead of at all its corners. Bullet asks for one some twenty times for each pair of bodies.
///
/// The corner is the one Bullet's own search returns, to the bit and with the same choice among equals, so
/// that contacts do not change.
class PrismShape final : public btConvexHullShape {
 public:
  /// @param corners      of the base [m], convex, counter-clockwise, 3 to 64, no side turned by less than
  ///                     3 degrees from the one before
  /// @param half_height  [m]
  PrismShape(std::span<const world::Vector2d> corners, double half_height);

  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override;

 private:
  static constexpr int buckets = 128;
  static constexpr int most_corners = 64;

  // The corners that can be the farthest one for directions of one bucket, rising.
  struct Candidates {
    unsigned char count = 0;
    std::array<unsigned char, 3> corner{};
  };
  void find_candidates(int bucket);

  int corners_ = 0;
  float half_height_ = 0;
  std::array<Candidates, buckets> candidates_{};  // by direction in the plane
};

}  // namespace physics
