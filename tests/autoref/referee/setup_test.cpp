#include "autoref/referee/setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace referee {
namespace {

using namespace std::chrono_literals;

TEST(Setup, IsReadBackAsItWasWritten) {
  referee::Setup setup;
  setup.rules = world::rule_set("paper");
  setup.rules.half_length = 12500ms;
  setup.first_kickoff = world::Team::Blue;
  setup.robots = {3, 6};
  EXPECT_EQ(setup_text(setup), "rules=paper half_length=12.5 first_kickoff=blue robots=3,6");
  const referee::Setup read = parse_setup(setup_text(setup));
  EXPECT_EQ(read.rules.name, "paper");
  EXPECT_EQ(read.rules.half_length, 12500ms);
  EXPECT_EQ(read.first_kickoff, world::Team::Blue);
  EXPECT_EQ(read.robots, (world::PerTeam<int>{3, 6}));
}

TEST(Setup, SaysWhenAWinnerIsWanted) {
  referee::Setup setup;
  setup.rules.winner = true;
  setup.rules.extra_half_length = 45s;
  EXPECT_EQ(setup_text(setup),
            "rules=ssl-2015 half_length=600 first_kickoff=yellow robots=6,6 winner=yes extra_half_length=45");
  const referee::Setup read = parse_setup(setup_text(setup));
  EXPECT_TRUE(read.rules.winner);
  EXPECT_EQ(read.rules.extra_half_length, 45s);
  EXPECT_FALSE(parse_setup("winner=no").rules.winner);
}

TEST(Setup, OfAnEmptyTextIsTheDefault) { EXPECT_EQ(parse_setup("").rules.name, "ssl-2015"); }

TEST(Setup, RefusesNonsenseByName) {
  for (const char* text :
       {"rules", "colour=red", "half_length=soon", "half_length=-1", "half_length=nan", "first_kickoff=green",
        "robots=6", "robots=6,99", "rules=ssl-1815", "winner=maybe", "extra_half_length=0"}) {
    try {
      parse_setup(text);
      ADD_FAILURE() << text << " was accepted";
    } catch (const std::invalid_argument& error) {
      const std::string value = std::string(text).substr(std::string(text).find('=') + 1);
      EXPECT_THAT(error.what(), ::testing::HasSubstr(value));
    }
  }
}

}  // namespace
}  // namespace referee
