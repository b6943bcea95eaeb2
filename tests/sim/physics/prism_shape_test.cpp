// Second method: Bullet's own search of all corners, which ours must follow to the bit.

#include "sim/physics/prism_shape.h"

#include <gtest/gtest.h>

#include "sim/physics/hull.h"
#include "sim/world/random.h"

namespace physics {
namespace {

class Prism : public testing::TestWithParam<int> {
 protected:
  Prism() : corners_(hull_corners(world::RobotSpecs{}, GetParam(), 0.001)), prism_(corners_, 0.074) {
    for (const world::Vector2d& corner : corners_) {
      for (const double z : {-0.074, 0.074}) {
        hull_.addPoint(
            {static_cast<float>(corner.x()), static_cast<float>(corner.y()), static_cast<float>(z)});
      }
    }
  }
  void expect_same(const btVector3& direction) const {
    const btVector3 ours = prism_.localGetSupportingVertexWithoutMargin(direction);
    const btVector3 bullets = hull_.localGetSupportingVertexWithoutMargin(direction);
    ASSERT_TRUE(ours == bullets) << direction.x() << " " << direction.y() << " " << direction.z();
  }

  std::vector<world::Vector2d> corners_;
  PrismShape prism_;
  btConvexHullShape hull_;
};

TEST_P(Prism, FindsTheCornerThatBulletFinds) {
  world::RandomStream random(1, "directions");
  const auto some = [&] { return static_cast<float>(2 * random.uniform() - 1); };
  for (int i = 0; i < 100'000; ++i) {
    const float z = some();
    for (const float scale : {1.0F, 0.3F, 0.01F, 1e-4F, 1e-9F, 0.0F}) {
      expect_same({some(), some(), z * scale});          // flat, as among robots
      expect_same({some() * scale, some() * scale, z});  // steep, as of a ball on top
    }
  }
}

// Straight at a side two corners are equally far, and with no slope both ends: the first in Bullet's list.
TEST_P(Prism, ChoosesAmongEqualsAsBulletDoes) {
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const world::Vector2d side = corners_[(i + 1) % corners_.size()] - corners_[i];
    for (const float z : {0.0F, -0.0F, 1e-6F, -1e-6F, 0.5F, -0.5F}) {
      expect_same({static_cast<float>(side.y()), static_cast<float>(-side.x()), z});
      expect_same({static_cast<float>(corners_[i].x()), static_cast<float>(corners_[i].y()), z});
    }
  }
  for (const float x : {-1.0F, -0.0F, 0.0F, 1.0F}) {
    for (const float y : {-1.0F, -0.0F, 0.0F, 1.0F}) {
      for (const float z : {-1.0F, 0.0F, 1.0F}) expect_same({x, y, z});
    }
  }
}

// 14 are the simulator's; few and many stand for other settings.
INSTANTIATE_TEST_SUITE_P(Segments, Prism, testing::Values(3, 14, 40));

}  // namespace
}  // namespace physics
