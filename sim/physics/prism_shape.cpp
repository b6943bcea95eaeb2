#include "sim/physics/prism_shape.h"

#include <cassert>
#include <cmath>

namespace physics {
namespace {

// Grows with the angle from 0 at +x to 4 after one turn, without trigonometry.
float turn(float x, float y) {
  const float part = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 2 - part;
  return y >= 0 ? part : 4 + part;
}

// Steeper directions see all corners of one end as equal within rounding; then only all of them will do.
constexpr float steep = 0.01F;

}  // namespace

PrismShape::PrismShape(std::span<const world::Vector2d> corners, double half_height)
    : corners_(static_cast<int>(corners.size())) {
  assert(corners.size() >= 3 && corners.size() < 256);
  m_shapeType = CUSTOM_POLYHEDRAL_SHAPE_TYPE;  // only for custom types Bullet asks our function
  for (const world::Vector2d& corner : corners) {
    for (const double z : {-half_height, half_height}) {
      addPoint({static_cast<float>(corner.x()), static_cast<float>(corner.y()), static_cast<float>(z)},
               false);
    }
  }
  recalcLocalAabb();
  for (int bucket = 0; bucket < buckets; ++bucket) {
    const double angle = 2 * M_PI * bucket / buckets;
    const float x = static_cast<float>(std::cos(angle)), y = static_cast<float>(std::sin(angle));
    int best = 0;
    for (int i = 1; i < corners_; ++i) {
      const btVector3 way(x, y, 0);
      if (way.dot(getUnscaledPoints()[2 * i]) > way.dot(getUnscaledPoints()[2 * best])) best = i;
    }
    const int at = static_cast<int>(turn(x, y) * (buckets / 4)) % buckets;
    first_guess_[static_cast<std::size_t>(at)] = static_cast<unsigned char>(best);
  }
}

// From the first guess uphill; the base is convex, so there is one top.
int PrismShape::nearest_corner(float x, float y) const {
  const btVector3* points = getUnscaledPoints();
  const auto height = [&](int corner) { return x * points[2 * corner].x() + y * points[2 * corner].y(); };
  const auto next = [&](int corner) { return corner + 1 == corners_ ? 0 : corner + 1; };
  const auto previous = [&](int corner) { return corner == 0 ? corners_ - 1 : corner - 1; };
  const auto bucket = static_cast<std::size_t>(turn(x, y) * (buckets / 4)) % buckets;
  int corner = first_guess_[bucket];
  float here = height(corner);
  for (const bool forward : {true, false}) {
    while (true) {
      const int candidate = forward ? next(corner) : previous(corner);
      const float there = height(candidate);
      if (!(there > here)) break;
      corner = candidate;
      here = there;
    }
  }
  return corner;
}

btVector3 PrismShape::localGetSupportingVertexWithoutMargin(const btVector3& direction) const {
  const float flat = std::abs(direction.x()) + std::abs(direction.y());
  if (!(flat > steep * std::abs(direction.z()))) {  // also when it is no number
    return btConvexHullShape::localGetSupportingVertexWithoutMargin(direction);
  }
  const int corner = nearest_corner(direction.x(), direction.y());
  // Rounding may make its neighbours and both ends equal; among equals Bullet takes the first in its list.
  const btVector3* points = getUnscaledPoints();
  float most = -SIMD_INFINITY;
  int best = 0;
  for (const int step : {-1, 0, 1}) {
    const int candidate = (corner + step + corners_) % corners_;
    for (const int index : {2 * candidate, 2 * candidate + 1}) {
      const float height = points[index].dot(direction);
      if (height > most || (height == most && index < best)) {
        most = height;
        best = index;
      }
    }
  }
  return points[best];
}

}  // namespace physics
