// Parameters of a team: the command line and the file, with one check for both.

#include "teams/kit/flags.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "teams/reference/parameters.h"

namespace {

using testing::HasSubstr;

class FlagsTest : public testing::Test {
 protected:
  FlagsTest() { reference::declare(flags_, parameters_); }
  ~FlagsTest() override { std::filesystem::remove(file_); }

  std::optional<int> parse(std::vector<const char*> arguments) {
    arguments.insert(arguments.begin(), "team");
    testing::internal::CaptureStderr();
    const auto code = flags_.parse(static_cast<int>(arguments.size()), arguments.data(), "team", "a team");
    error_ = testing::internal::GetCapturedStderr();
    return code;
  }
  std::optional<int> parse_file(const std::string& text) {
    std::ofstream(file_) << text;
    return parse({"--config", file_.c_str()});
  }

  reference::Parameters parameters_;
  kit::Flags flags_;
  std::string error_;
  const std::string file_ =
      testing::TempDir() + "flags_" + testing::UnitTest::GetInstance()->current_test_info()->name() + ".toml";
};

TEST_F(FlagsTest, AFileSetsWhatTheCommandLineLeaves) {
  std::ofstream(file_) << "shot-speed = 5\nturn-dribble = false\nattack = \"greedy\"\ndefenders = 1\n";
  EXPECT_EQ(parse({"--config", file_.c_str(), "--shot-speed", "6"}), std::nullopt) << error_;
  EXPECT_EQ(parameters_.shot_speed, 6);
  EXPECT_EQ(parameters_.defenders, 1);
  EXPECT_EQ(parameters_.attack, "greedy");
  EXPECT_FALSE(parameters_.turn_dribble);
}

TEST_F(FlagsTest, EveryBadFileIsOneSentenceWithFileLineKeyAndValue) {
  EXPECT_EQ(parse_file("stop-speed = 1\nshot-speed = 9\n"), 2);
  EXPECT_THAT(error_, HasSubstr(file_ + ":2: shot-speed must be a number between 1 and 7 instead of '9'"));
  EXPECT_EQ(parse_file("shot-sped = 5\n"), 2);
  EXPECT_THAT(error_, HasSubstr(":1: shot-sped is no parameter of this team"));
  EXPECT_EQ(parse_file("defenders = 1.5\n"), 2);
  EXPECT_THAT(error_, HasSubstr("defenders must be a whole number between 0 and 4 instead of '1.5'"));
  EXPECT_EQ(parse_file("shot-speed = nan\n"), 2);
  EXPECT_EQ(parse_file("turn-dribble = 1\n"), 2);
  EXPECT_THAT(error_, HasSubstr("must be on or off instead of '1'"));
  EXPECT_EQ(parse_file("shot-speed = [5]\n"), 2);
  EXPECT_THAT(error_, HasSubstr("must be a number, true, false or a string"));
  EXPECT_EQ(parse_file("shot-speed = = 5\n"), 2);
  EXPECT_THAT(error_, HasSubstr(":1: is no TOML"));
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1);
}

TEST_F(FlagsTest, AMissingFileAndABadFlagAreRefused) {
  EXPECT_EQ(parse({"--config", "/there/is/no.toml"}), 2);
  EXPECT_THAT(error_, HasSubstr("/there/is/no.toml: cannot be read"));
  EXPECT_EQ(parse({"--attack", "both"}), 2);
  EXPECT_THAT(error_, HasSubstr("--attack must be one of zones|greedy instead of 'both'"));
  EXPECT_EQ(parse({"--no-such-flag"}), 2);
}

TEST_F(FlagsTest, HelpListsEveryParameterWithRangeAndDefault) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(parse({"--help"}), 0);
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_THAT(help, HasSubstr("--shot-speed 1..7 [6.5]"));
  EXPECT_THAT(help, HasSubstr("--turn-dribble on|off [on]"));
  EXPECT_THAT(help, HasSubstr("--attack zones|greedy [zones]"));
}

}  // namespace
