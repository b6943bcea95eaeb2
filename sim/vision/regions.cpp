#include "sim/vision/regions.h"

#include <algorithm>
#include <numbers>

namespace vision {

using world::Vector2d;

Regions::Regions(const Params& params, const Area& area, world::RandomStream stream)
    : radius_(params.region_radius) {
  for (int i = 0; i < params.regions; ++i) {
    const double x = stream.uniform(), y = stream.uniform(), turn = stream.uniform();
    regions_.push_back({area.at(x, y), params.region_offset * world::direction(2 * std::numbers::pi * turn)});
  }
}

bool Regions::contains(const Vector2d& point) const {
  return std::any_of(regions_.begin(), regions_.end(), [&](const Region& region) {
    return (point - region.center).squaredNorm() < radius_ * radius_;
  });
}

Vector2d Regions::offset(const Vector2d& point) const {
  Vector2d sum = Vector2d::Zero();
  for (const Region& region : regions_) {
    const double distance = (point - region.center).norm();
    if (distance < radius_) sum += (1 - distance / radius_) * region.error;
  }
  return sum;
}

}  // namespace vision
