#include "sim/engine/realism.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace engine {
namespace {

using testing::HasSubstr;

std::string complaint(std::string_view key, double value) {
  Realism realism;
  try {
    set(realism, key, value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(RealismKeys, EachStandsForANumberOfItsOwn) {
  for (const RealismKey& key : realism_keys()) {
    Realism changed;
    const double value = key.get(changed) == key.highest ? key.lowest : key.highest;  // 8 or 1 cameras
    set(changed, key.name, value);
    EXPECT_EQ(key.get(changed), value) << key.name;
    const Realism untouched;
    for (const RealismKey& other : realism_keys()) {
      if (other.name == key.name) continue;
      EXPECT_EQ(other.get(changed), other.get(untouched)) << key.name << " " << other.name;
    }
  }
}

TEST(RealismKeys, HaveNamesOfTheirOwnAndAMeaning) {
  std::set<std::string_view> names;
  for (const RealismKey& key : realism_keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_FALSE(key.meaning.empty()) << key.name;
    EXPECT_LT(key.lowest, key.highest) << key.name;
  }
}

TEST(RealismKeys, PresetsAreWithinTheirRanges) {
  for (const Realism& preset : realism_presets()) {
    for (const RealismKey& key : realism_keys()) {
      Realism copy = preset;
      EXPECT_NO_THROW(set(copy, key.name, key.get(preset))) << preset.name << " " << key.name;
    }
  }
}

TEST(RealismKeys, BadOnesAreNamedWithRangeOrHint) {
  EXPECT_EQ(complaint("vision.ball_sigma", 0.001), "accepted");
  EXPECT_THAT(complaint("vision.ball_sigma", 0.2),
              HasSubstr("vision.ball_sigma = 0.2: must be from 0 to 0.1 m"));
  EXPECT_THAT(complaint("vision.ball_sigma", std::nan("")), HasSubstr("must be from"));
  EXPECT_THAT(complaint("vision.delay", 0.5), HasSubstr("whole number of ticks"));
  EXPECT_THAT(complaint("vision.cameras", 3), HasSubstr("1, 2, 4, 6 or 8"));
  EXPECT_THAT(complaint("vision.balls_sigma", 0), HasSubstr("did you mean vision.ball_sigma?"));
  EXPECT_THAT(complaint("", 0), HasSubstr("no key \"\""));
}

// Issue 3 names these numbers.
TEST(RealismPresets, HaveThePromisedNumbers) {
  const vision::Params& measured = realism("measured").vision;
  EXPECT_EQ(measured.ball_sigma, 0.0005);
  EXPECT_EQ(measured.robot_sigma, 0.00055);
  EXPECT_EQ(measured.orientation_sigma, 0.0035);
  EXPECT_EQ(measured.bias_sigma, 0.010);
  EXPECT_GT(measured.visible_share, 0);
  const vision::Params& harsh = realism("harsh").vision;
  EXPECT_EQ(harsh.ball_sigma, 0.0014);
  EXPECT_EQ(harsh.ball_missing, 0.05);
  EXPECT_EQ(harsh.robot_missing, 0.02);
  EXPECT_GT(harsh.ball_burst_start, 0);
  EXPECT_GT(harsh.false_ball_rate, 0);
  EXPECT_GT(harsh.visible_share, 0);
  for (const RealismKey& key : realism_keys()) {
    if (!key.name.starts_with("actuators.")) continue;
    EXPECT_EQ(key.get(realism("none")), 0) << key.name;
    EXPECT_GT(key.get(realism("measured")), 0) << key.name;
    EXPECT_EQ(key.get(realism("harsh")), 2 * key.get(realism("measured"))) << key.name;
  }
}

}  // namespace
}  // namespace engine
