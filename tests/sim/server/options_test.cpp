#include "sim/server/options.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>

#include "sim/server/realism_file.h"

namespace {

using server::Options;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string error_of(const std::function<void(Options&)>& spoil) {
  Options options;
  spoil(options);
  try {
    check(options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(RobotNumbers, AreRangesAndLists) {
  EXPECT_THAT(server::parse_numbers("0-5"), ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_THAT(server::parse_numbers("7"), ElementsAre(7));
  EXPECT_THAT(server::parse_numbers("9,0-2,1"), ElementsAre(0, 1, 2, 9));
  EXPECT_THAT(server::parse_numbers("none"), IsEmpty());
  for (const char* bad : {"", "16", "0-16", "5-3", "1-2-3", "a", "1,", "-1", "1 2", "0x3"}) {
    EXPECT_THROW(server::parse_numbers(bad), std::invalid_argument) << bad;
  }
}

TEST(Options, AreGoodByDefault) {
  EXPECT_EQ(error_of([](Options&) {}), "");
  EXPECT_EQ(server::robots(Options{}).blue.size(), 6U);
  EXPECT_EQ(server::make_setup(Options{}).realism.name, "measured");
}

TEST(Options, SetIsAppliedAfterThePreset) {
  Options options;
  options.realism = "none";
  options.set = {"vision.ball_sigma=0.002", "radio.latency=4", "robots.max_speed=2", "radio.latency=5"};
  const server::Setup setup = server::make_setup(options);
  EXPECT_EQ(setup.realism.vision.ball_sigma, 0.002);
  EXPECT_EQ(setup.realism.radio.latency, 5);
  EXPECT_EQ(setup.specs.yellow[15].max_speed, 2);
}

TEST(RealismFile, IsAPresetAndNumbersByDottedKeysOrInTables) {
  const engine::Realism realism = server::parse_realism(R"(
# as calibrate and `matchday realism` write it
name = "of a design: does not count"
[realism]
preset = "none"
radio.latency = 4
"vision.ball_sigma" = 0.002
[realism.vision]
robot_sigma = 0.001  # [m]
[realism.robots]
max_speed = 2
)",
                                                        "field.toml");
  engine::Realism expected = engine::realism("none");
  engine::set(expected, "radio.latency", 4);
  engine::set(expected, "vision.ball_sigma", 0.002);
  engine::set(expected, "vision.robot_sigma", 0.001);
  engine::set(expected, "robots.max_speed", 2);
  for (const engine::RealismKey& key : engine::realism_keys()) {
    EXPECT_EQ(key.get(realism), key.get(expected)) << key.name;
  }
  EXPECT_EQ(server::parse_realism("[realism]\n", "a.toml").name, "measured") << "as in designs";
  EXPECT_EQ(server::parse_realism("realism = \"harsh\"", "a.toml").name, "harsh") << "as in designs";
}

TEST(RealismFile, EveryKeyCanBeSaidAndIsTaken) {
  std::string text = "[realism]\npreset = \"harsh\"\n";
  for (const engine::RealismKey& key : engine::realism_keys()) {
    text += fmt::format("{} = {}\n", key.name, key.get(engine::realism("harsh")));
  }
  const engine::Realism realism = server::parse_realism(text, "all.toml");
  for (const engine::RealismKey& key : engine::realism_keys()) {
    EXPECT_EQ(key.get(realism), key.get(engine::realism("harsh"))) << key.name;
  }
}

TEST(RealismFile, AMistakeIsNamedWithFileAndLine) {
  const auto error = [](const std::string& text) -> std::string {
    try {
      server::parse_realism(text, "f.toml");
    } catch (const std::invalid_argument& mistake) {
      return mistake.what();
    }
    return "";
  };
  EXPECT_THAT(error("[realism]\npreset = \"real\"\n"), StartsWith("f.toml:2: realism \"real\" is not known"));
  EXPECT_THAT(error("[realism]\n\nradio.los = 0\n"),
              AllOf(StartsWith("f.toml:3: "), HasSubstr("radio.loss")));
  EXPECT_EQ(error("[realism]\n[realism.radio]\nloss = 2\n"),
            "f.toml:3: realism radio.loss = 2: must be from 0 to 1");
  EXPECT_THAT(error("[realism]\nradio.loss = 9007199254740993\n"), HasSubstr("must be from 0 to 1"))
      << "no double is this number";
  EXPECT_EQ(error("[realism.radio]\nloss = \"2\"\n"), "f.toml:2: realism radio.loss must be a number");
  EXPECT_THAT(error("[realism]\npreset = 3"), StartsWith("f.toml:2: the preset must be a text"));
  EXPECT_THAT(error("x = 1\n[realism\n"), StartsWith("f.toml:2: not TOML: "));
  EXPECT_THAT(error("[real]\n"), HasSubstr("no table [realism]"));
  EXPECT_THAT(error("realism = 3"), HasSubstr("must be a table"));
}

TEST(RealismFile, IsWhatEndsInToml) {
  const auto error = [](const std::string& word) { return error_of([&](Options& o) { o.realism = word; }); };
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / fmt::format("realism-{}", getpid());
  std::filesystem::create_directories(folder / "dir.toml");
  std::ofstream(folder / "good.toml") << "realism.preset = \"none\"\nrealism.radio.latency = 4\n";
  std::ofstream(folder / "good.txt") << "realism.preset = \"none\"\n";
  Options options;
  options.realism = folder / "good.toml";
  options.set = {"radio.loss=0.5"};
  EXPECT_EQ(server::make_setup(options).realism.radio.latency, 4);
  EXPECT_EQ(server::make_setup(options).realism.radio.loss, 0.5) << "on top of the file";
  EXPECT_THAT(error(folder / "dir.toml"), HasSubstr("is a directory"));
  EXPECT_THAT(error(folder), HasSubstr("is a directory"));
  EXPECT_THAT(error(folder / "good.txt"), HasSubstr("must end in .toml"));
  EXPECT_THAT(error(folder / "none.toml"), HasSubstr("none.toml: cannot be read"));
  EXPECT_THAT(error("perfect"), HasSubstr("or a file that ends in .toml"));
  std::filesystem::remove_all(folder);
}

TEST(Options, EveryMistakeIsOneSentenceWithTheFlag) {
  EXPECT_THAT(error_of([](Options& o) { o.rules = "x"; }), HasSubstr("'x'"));
  EXPECT_THAT(error_of([](Options& o) { o.realism = "x"; }), HasSubstr("\"x\""));
  EXPECT_THAT(error_of([](Options& o) { o.set = {"x"}; }), HasSubstr("--set x"));
  EXPECT_THAT(error_of([](Options& o) { o.set = {"radio.loss=much"}; }), HasSubstr("KEY=NUMBER"));
  EXPECT_THAT(error_of([](Options& o) { o.set = {"radio.loss="}; }), HasSubstr("KEY=NUMBER"));
  EXPECT_THAT(error_of([](Options& o) { o.set = {"radio.los=0"}; }), HasSubstr("radio.loss"));
  EXPECT_THAT(error_of([](Options& o) { o.set = {"vision.cameras=5"}; }), HasSubstr("5"));
  EXPECT_THAT(error_of([](Options& o) { o.blue = "0-20"; }), HasSubstr("0-20"));
  EXPECT_THAT(error_of([](Options& o) { o.speed = -1; }), HasSubstr("--speed -1"));
  EXPECT_THAT(error_of([](Options& o) { o.speed = std::numeric_limits<double>::quiet_NaN(); }),
              HasSubstr("--speed nan"));
  EXPECT_THAT(error_of([](Options& o) { o.duration = 0; }), HasSubstr("--duration 0"));
  EXPECT_THAT(error_of([](Options& o) { o.interface = "eth0"; }), HasSubstr("--interface eth0"));
  EXPECT_THAT(error_of([](Options& o) { o.vision_address = "10.0.0.1"; }), HasSubstr("--vision-address"));
  EXPECT_THAT(error_of([](Options& o) { o.vision_port = 0; }), HasSubstr("--vision-port"));
  EXPECT_THAT(error_of([](Options& o) { o.yellow_port = 70000; }), HasSubstr("--yellow-port 70000"));
  EXPECT_EQ(error_of([](Options& o) { o.control_port = 0; }), "") << "any free one";
  EXPECT_EQ(error_of([](Options& o) { o.control_port = o.blue_port = 0; }), "") << "two of them";
  EXPECT_EQ(error_of([](Options& o) { o.blue_port = o.yellow_port; }),
            "--blue-port 10302 and --yellow-port 10302: must not be the same");
}
