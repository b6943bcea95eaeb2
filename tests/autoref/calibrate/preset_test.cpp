#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>

#include "autoref/calibrate/calibration.h"
#include "autoref/calibrate/preset_keys.h"
#include "sim/engine/realism.h"
#include "tests/autoref/calibrate/scene.h"

namespace calibrate {
namespace {

// The referee's side may not include the simulator; its copy of names and ranges is the simulator's.
TEST(PresetKeys, AreTheSimulatorsWithTheirRanges) {
  std::size_t last = 0;
  for (const PresetKey& key : preset_keys()) {
    const auto all = engine::realism_keys();
    const auto found = std::ranges::find(all, key.name, &engine::RealismKey::name);
    ASSERT_NE(found, all.end()) << key.name;
    EXPECT_EQ(key.lowest, found->lowest) << key.name;
    EXPECT_EQ(key.highest, found->highest) << key.name;
    EXPECT_EQ(key.whole, found->whole) << key.name;
    const auto place = static_cast<std::size_t>(found - all.begin());
    EXPECT_GE(place, last) << key.name << " is out of order";
    last = place;
  }
}

// Takes a preset as the simulator does, and gives how many numbers it set.
int applied(const std::string& text, engine::Realism& realism) {
  const toml::table document = toml::parse(text);
  const toml::table& table = *document["realism"].as_table();
  realism = engine::realism(table["preset"].value<std::string>().value());
  int numbers = 0;
  for (const auto& [section, keys] : table) {
    if (section == "preset") continue;
    for (const auto& [name, value] : *keys.as_table()) {
      const std::string key = std::string(section.str()) + "." + std::string(name.str());
      engine::set(realism, key, value.value<double>().value());
      ++numbers;
    }
  }
  return numbers;
}

TEST(Preset, IsOneThatTheSimulatorTakes) {
  scene::Errors errors;
  errors.ball = {0.02, 0.004, 10};
  errors.false_ball_rate = 0.2;
  Observer observer;
  for (const world::Detection& image : scene::images(4, 120, errors, 1)) observer.add(image);
  const Report report = calibrated(observer.finish(), scene::geometry(4));
  engine::Realism realism;
  const int numbers = applied(to_toml(report, "a \"log\"\nof two lines"), realism);
  EXPECT_GE(numbers, 15);
  EXPECT_EQ(realism.vision.cameras, 4);
  EXPECT_NEAR(realism.vision.ball_sigma, 0.0005, 0.00005);
  EXPECT_NEAR(realism.vision.ball_burst_length, 10, 3 * report.find("vision.ball_burst_length")->error);
  // The ball here is led by hand: no rolling, no kick; the preset keeps what it is based on.
  EXPECT_EQ(realism.robots.max_kick_speed, engine::realism("measured").robots.max_kick_speed);
}

TEST(Preset, LeavesOutWhatThePresetCannotHold) {
  Report report;
  report.add("vision.ball_sigma", "ball noise", "m", {0.2, 0.01, 100}, "made up");
  report.add("vision.overlap", "overlap", "m", {2, 0.1, 4}, "made up");
  report.add("vision.delay", "delay", "ticks", {2.4, 0.1, 4}, "made up");
  EXPECT_FALSE(report.find("vision.ball_sigma")->value);
  engine::Realism realism;
  EXPECT_EQ(applied(to_toml(report, "t"), realism), 2);
  EXPECT_EQ(realism.vision.overlap, 2);
  EXPECT_EQ(realism.vision.delay, 2);
  EXPECT_EQ(realism.vision.ball_sigma, engine::realism("measured").vision.ball_sigma);
}

}  // namespace
}  // namespace calibrate
