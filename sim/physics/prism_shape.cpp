#include "sim/physics/prism_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace physics {
namespace {

// Grows with the angle from 0 at +x to 4 after one turn, without trigonometry.
float turn(float x, float y) {
  const float part = y / (std::abs(x) + std::abs(y));
  if (x < 0) return 2 - part;
  return y >= 0 ? part : 4 + part;
}

// A direction of that turn; its length is not 1.
world::Vector2d direction(double turn) {
  turn = std::remainder(turn, 4.0);  // -2 to 2
  const double x = 1 - std::abs(turn);
  return {x, std::copysign(1 - std::abs(x), turn)};
}

// Steeper directions see all corners of one end as equal within rounding; then only all of them will do.
constexpr float steep = 0.01F;

}  // namespace

PrismShape::PrismShape(std::span<const world::Vector2d> corners, double half_height)
    : corners_(static_cast<int>(corners.size())), half_height_(static_cast<float>(half_height)) {
  assert(corners.size() >= 3 && corners.size() <= most_corners);
  m_shapeType = CUSTOM_POLYHEDRAL_SHAPE_TYPE;  // only for custom types Bullet asks our function
  for (const world::Vector2d& corner : corners) {
    for (const float z : {-half_height_, half_height_}) {
      addPoint({static_cast<float>(corner.x()), static_cast<float>(corner.y()), z}, false);
    }
  }
  recalcLocalAabb();
  for (int bucket = 0; bucket < buckets; ++bucket) find_candidates(bucket);
}

// Looked for at many directions of the bucket and a little beyond it, so that what rounding makes equal to
// the farthest one is among them.
void PrismShape::find_candidates(int bucket) {
  constexpr int samples = 32;
  constexpr double beyond = 0.1;  // of a bucket: 0.2 degrees at least, rounding is 1e-5 of it
  Candidates& found = candidates_[static_cast<std::size_t>(bucket)];
  std::array<bool, most_corners> farthest{};
  for (int sample = 0; sample <= samples; ++sample) {
    const double place = bucket - beyond + (1 + 2 * beyond) * sample / samples;
    const world::Vector2d way = direction(place * 4 / buckets);
    const auto height = [&](int i) {
      const btVector3& point = getUnscaledPoints()[2 * i];
      return way.x() * static_cast<double>(point.x()) + way.y() * static_cast<double>(point.y());
    };
    int best = 0;
    for (int i = 1; i < corners_; ++i) {
      if (height(i) > height(best)) best = i;
    }
    farthest[static_cast<std::size_t>(best)] = true;
  }
  for (int i = 0; i < corners_; ++i) {
    if (!farthest[static_cast<std::size_t>(i)]) continue;
    assert(found.count < found.corner.size());
    found.corner[found.count++] = static_cast<unsigned char>(i);
  }
}

btVector3 PrismShape::localGetSupportingVertexWithoutMargin(const btVector3& way) const {
  const float x = way.x(), y = way.y(), z = way.z();
  if (!(std::abs(x) + std::abs(y) > steep * std::abs(z))) {  // also when it is no number
    return btConvexHullShape::localGetSupportingVertexWithoutMargin(way);
  }
  const int bucket = std::min(static_cast<int>(turn(x, y) * (buckets / 4)), buckets - 1);
  const Candidates& candidates = candidates_[static_cast<std::size_t>(bucket)];
  const btVector3* points = getUnscaledPoints();
  // In the order of Bullet's list, of which it takes the first among equals. The sum is Bullet's dot product.
  const float up = z * half_height_;
  float most = -SIMD_INFINITY;
  int best = 0;
  for (int i = 0; i < candidates.count; ++i) {
    const int index = 2 * candidates.corner[static_cast<std::size_t>(i)];
    const float flat = x * points[index].x() + y * points[index].y();
    if (flat - up > most) {
      most = flat - up;
      best = index;
    }
    if (flat + up > most) {
      most = flat + up;
      best = index + 1;
    }
  }
  return points[best];
}

}  // namespace physics
