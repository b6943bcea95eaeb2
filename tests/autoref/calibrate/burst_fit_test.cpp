#include "autoref/calibrate/burst_fit.h"

#include <gtest/gtest.h>

#include "sim/world/random.h"

namespace calibrate {
namespace {

struct Channel {
  double missing, start, length;
};

Gaps gaps_of(const Channel& channel, int images, std::uint64_t seed) {
  world::RandomStream random(seed, "gaps");
  Gaps gaps;
  std::size_t missed = 0;
  bool burst = false;
  for (int i = 0; i < images; ++i) {
    burst = burst ? random.uniform() >= 1 / channel.length : random.uniform() < channel.start;
    if (burst || random.uniform() < channel.missing) {
      ++missed;
      continue;
    }
    gaps.add(missed);
    missed = 0;
  }
  return gaps;
}

// Estimates within 3 of their own errors for nearly all channels and seeds: of 45 numbers none further than
// 4, and at most 3 further than 2.5 (expected 0.6).
TEST(BurstFit, FindsTheChannelWithinItsErrors) {
  int far = 0;
  for (const Channel channel :
       {Channel{0.05, 0.002, 15}, Channel{0.01, 0.0005, 60}, Channel{0.02, 0.004, 5}}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const BurstFit fit = fit_bursts(gaps_of(channel, 200'000, seed));
      for (const auto& [found, truth] :
           {std::pair{fit.missing, channel.missing}, std::pair{fit.start, channel.start},
            std::pair{fit.length, channel.length}}) {
        ASSERT_GT(found.error, 0);
        const double off = std::abs(found.value - truth) / found.error;
        EXPECT_LT(off, 4) << found.value << " +- " << found.error << " for " << truth << ", seed " << seed;
        EXPECT_LT(found.error, 0.5 * truth);  // it says something
        far += off > 2.5;
      }
    }
  }
  EXPECT_LE(far, 3);
}

TEST(BurstFit, SeesNoBurstsInSingleMisses) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const BurstFit fit = fit_bursts(gaps_of({0.05, 0, 5}, 50'000, seed));
    EXPECT_EQ(fit.start.value, 0) << seed;
    EXPECT_NEAR(fit.missing.value, 0.05, 4 * fit.missing.error);
  }
}

TEST(BurstFit, OfBurstsAloneFindsNoSingleMisses) {
  const BurstFit fit = fit_bursts(gaps_of({0, 0.002, 20}, 200'000, 3));
  EXPECT_LT(fit.missing.value, 1e-4);  // 3 of 200 000 images would be 1.5e-5
  EXPECT_NEAR(fit.start.value, 0.002, 4 * fit.start.error);
  EXPECT_NEAR(fit.length.value, 20, 4 * fit.length.error);
}

// Gaps that nobody could follow to their end tell what they were: here every gap is cut
// after at most 10 images.
TEST(BurstFit, UsesGapsThatStayedOpen) {
  const Gaps whole = gaps_of({0.02, 0.002, 25}, 200'000, 4);
  Gaps cut;
  for (std::size_t n = 0; n < whole.ended.size(); ++n) {
    for (std::int64_t i = 0; i < whole.ended[n]; ++i) cut.add(std::min<std::size_t>(n, 10), n > 10);
  }
  const BurstFit fit = fit_bursts(cut);
  EXPECT_NEAR(fit.missing.value, 0.02, 4 * fit.missing.error);
  EXPECT_NEAR(fit.start.value, 0.002, 4 * fit.start.error);
  EXPECT_NEAR(fit.length.value, 25, 4 * fit.length.error);
  EXPECT_LT(fit.length.error, 5);
}

TEST(BurstFit, WithoutAnyMissGivesZerosWithBounds) {
  const BurstFit fit = fit_bursts({{1000}, {}});
  EXPECT_EQ(fit.missing.value, 0);
  EXPECT_EQ(fit.start.value, 0);
  EXPECT_DOUBLE_EQ(fit.start.error, 0.003);
}

}  // namespace
}  // namespace calibrate
