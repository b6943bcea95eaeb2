#include "sim/server/options.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <stdexcept>

namespace {

using server::Options;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
}
