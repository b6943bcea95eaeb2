#include "sim/world/detection.h"

#include <gtest/gtest.h>

#include "sim/world/random.h"

namespace world {
namespace {

TEST(AsOnWire, RoundingTwiceChangesNothingMore) {
  RandomStream stream(6, "detection test");
  for (int i = 0; i < 10'000; ++i) {
    const double once = as_on_wire(stream.uniform() * 14 - 7);
    EXPECT_EQ(as_on_wire(once), once);
  }
}

TEST(AsOnWire, MovesAPointByLessThanAMicrometre) {
  RandomStream stream(7, "detection test");
  for (int i = 0; i < 10'000; ++i) {
    const double value = stream.uniform() * 14 - 7;
    // Floats of up to 7000 mm are 2^-11 mm apart; rounding moves by at most half of that.
    EXPECT_NEAR(as_on_wire(value), value, 0.25e-6);
  }
}

}  // namespace
}  // namespace world
