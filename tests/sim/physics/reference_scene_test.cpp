#include "sim/physics/reference_scene.h"

#include <gtest/gtest.h>

namespace {

TEST(ReferenceScene, IsTheSameEveryTime) {
  const physics::ReferenceResult one = physics::run_reference_scene(10);
  EXPECT_EQ(one.ticks, 600);
  EXPECT_EQ(one.hash, physics::run_reference_scene(10).hash);
  EXPECT_NE(one.hash, physics::run_reference_scene(9).hash);
}

// Recorded when the scene was frozen. The hash holds for Debian's Bullet 3.24 and a libm that uses fused
// multiply-add (it picks its sine by CPU), hence the condition; a change of this number means the unit of all
// speed ratios changed.
TEST(ReferenceScene, IsStillTheFrozenOne) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "recorded on a CPU with FMA";
  EXPECT_EQ(physics::run_reference_scene(60).hash, 46427724389691841U);
#else
  GTEST_SKIP() << "recorded on x86-64";
#endif
}

}  // namespace
