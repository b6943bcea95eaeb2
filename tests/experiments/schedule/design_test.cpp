#include "experiments/schedule/design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <stdexcept>

#include "experiments/schedule/schedule.h"
#include "sim/engine/realism.h"

namespace schedule {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string teams = R"(
[teams.a]
name = "ours"
command = ["team-reference", "--press"]
[teams.b]
command = "team-chaser --slow 'very much'"
)";

void check_realism(const record::RealismConfig& config) {
  engine::Realism realism = engine::realism(config.preset);
  for (const auto& [key, value] : config.changes) engine::set(realism, key, value);
}

/// What the parser says about a text, or "accepted".
std::string complaint(const std::string& text) {
  try {
    parse_design(text, "night.toml", check_realism);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Design, ReadsEverything) {
  const Design design = parse_design(R"(name = "night"
description = "two of everything"
seed = 42
games = 6
realism = "friendly"
forfeit_goals = 5
[rules]
set = "paper"
half_length = 30
winner = true
[teams.a]
command = ["team-reference"]
[teams.b]
name = "other"
command = "team-chaser"
robots = [0, 5]
[[conditions]]
name = "as-they-are"
[[conditions]]
name = "changed"
a.arguments = ["--x", "1"]
a.speed_factor = 0.5
b = { command = ["python3", "team.py"], robots = [1], arguments = ["-v"] }
)",
                                     "night.toml");
  EXPECT_EQ(design.name, "night");
  EXPECT_EQ(design.description, "two of everything");
  EXPECT_EQ(design.seed, 42U);
  EXPECT_EQ(design.pairs, 3);
  EXPECT_EQ(design.realism.preset, "friendly");
  EXPECT_EQ(design.forfeit_goals, 5);
  EXPECT_EQ(design.rules, "paper");
  EXPECT_EQ(design.half_length, 30);
  EXPECT_TRUE(design.winner);
  ASSERT_EQ(design.conditions.size(), 2U);
  EXPECT_EQ(design.conditions[0].name, "as-they-are");
  EXPECT_EQ(design.conditions[0].a.name, "team-reference");
  EXPECT_THAT(design.conditions[0].b.robots, ElementsAre(0, 5));
  EXPECT_THAT(design.conditions[1].a.command, ElementsAre("team-reference", "--x", "1"));
  EXPECT_EQ(design.conditions[1].a.speed_factor, 0.5);
  EXPECT_THAT(design.conditions[1].b.command, ElementsAre("python3", "team.py", "-v"));
  EXPECT_THAT(design.conditions[1].b.robots, ElementsAre(1));
  EXPECT_EQ(design.conditions[1].b.name, "other");
}

TEST(Design, HasSixRobotsFullSpeedAndOneConditionIfNothingElseIsSaid) {
  const Design design = parse_design("name = \"n\"\npairs = 1" + teams, "n.toml");
  ASSERT_EQ(design.conditions.size(), 1U);
  EXPECT_EQ(design.conditions[0].name, "base");
  EXPECT_THAT(design.conditions[0].a.robots, ElementsAre(0, 1, 2, 3, 4, 5));
  EXPECT_EQ(design.conditions[0].a.speed_factor, 1);
  EXPECT_THAT(design.conditions[0].b.command, ElementsAre("team-chaser", "--slow", "very much"));
  EXPECT_EQ(design.rules, "ssl-2015");
  EXPECT_EQ(design.realism.preset, "measured");
  EXPECT_FALSE(design.half_length);
}

struct Mistake {
  std::string text;
  std::string message;  ///< how the complaint begins
};

/// Test names show which mistake it is.
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.message; }

class DesignMistake : public testing::TestWithParam<Mistake> {};

TEST_P(DesignMistake, IsNamedWithFileLineKeyValueAndHint) {
  EXPECT_THAT(complaint(GetParam().text), HasSubstr(GetParam().message));
}

const std::string head = "name = \"n\"\npairs = 1\n";

INSTANTIATE_TEST_SUITE_P(
    All, DesignMistake,
    testing::Values(
        Mistake{"name = \"n\nx", "night.toml:1: not TOML: "},
        Mistake{"pairs = 1" + teams, "night.toml:1: name is missing; give the experiment a name"},
        Mistake{"name = \"a b\"\npairs = 1" + teams, "night.toml:1: name = 'a b': use letters"},
        Mistake{"name = \"n\"" + teams, "pairs is missing; give the number of pairs"},
        Mistake{"name = \"n\"\npairs = 0" + teams, "night.toml:2: pairs = 0: must be from 1 to 100000"},
        Mistake{"name = \"n\"\ngames = 7" + teams, "night.toml:2: games = 7: must be even"},
        Mistake{"name = \"n\"\ngames = 8\npairs = 4" + teams, "night.toml:2: games = 8: give either"},
        Mistake{"name = \"n\"\npairs = \"4\"" + teams, "night.toml:2: pairs = '4': must be a whole number"},
        Mistake{head + "seed = -1" + teams, "night.toml:3: seed = -1: must not be negative"},
        Mistake{head + "sed = 1" + teams, "night.toml:3: unknown key sed = 1; known here are: name, "},
        Mistake{head + "realism = \"real\"" + teams,
                "night.toml:3: realism \"real\" is not known; known are none, friendly"},
        Mistake{head + "[realism]\npreset = 3" + teams, "night.toml:4: realism.preset = 3: must be a text"},
        Mistake{head + "[realism]\nvision.ball_sigma = \"x\"" + teams,
                "night.toml:4: realism.vision.ball_sigma = 'x': must be a number"},
        Mistake{head + "[realism]\n[realism.vision]\nball_sigma = 5" + teams,
                "night.toml:5: realism vision.ball_sigma = 5: must be from 0 to 0.1 m"},
        Mistake{head + "[realism]\nvision.ball_sigma = nan" + teams,
                "night.toml:4: realism vision.ball_sigma = nan: must be from"},
        Mistake{head + "[realism]\nvision.ball_sgma = 0" + teams,
                "night.toml:4: realism has no key \"vision.ball_sgma\"; did you mean vision.ball_sigma?"},
        Mistake{head + "[realism]\nvision.delay = 0.5" + teams,
                "night.toml:4: realism vision.delay = 0.5: must be a whole number of ticks"},
        Mistake{head + "forfeit_goals = 0" + teams, "night.toml:3: forfeit_goals = 0: must be from 1"},
        Mistake{head + "rules = \"paper\"" + teams, "night.toml:3: rules = 'paper': must be a table"},
        Mistake{head + "[rules]\nset = \"fifa\"" + teams,
                "night.toml:4: rules.set = 'fifa': there is no such one; known are: ssl-2015"},
        Mistake{head + "[rules]\nhalf_length = 0" + teams,
                "night.toml:4: rules.half_length = 0: must be from 1"},
        Mistake{head + "[rules]\nwinner = 1" + teams,
                "night.toml:4: rules.winner = 1: must be true or false"},
        Mistake{head + "[rules]\nhalf_length = nan" + teams,
                "night.toml:4: rules.half_length = nan: must be from"},
        Mistake{head + "[rules]\nhalf = 3" + teams, "night.toml:4: unknown key rules.half = 3"},
        Mistake{head, "teams is missing; give both teams"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\n", "teams.b is missing"},
        Mistake{head + "[teams.a]\nname = \"x\"\n", "night.toml:3: teams.a.command is missing"},
        Mistake{head + "[teams.a]\ncommand = []\n", "night.toml:4: teams.a.command = []: must begin with"},
        Mistake{head + "[teams.a]\ncommand = \"x 'y\"\n",
                "night.toml:4: teams.a.command = \"x 'y\": command"},
        Mistake{head + "[teams.a]\ncommand = [1]\n",
                "night.toml:4: teams.a.command = [ 1 ]: must be a list of texts"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = 6\n",
                "night.toml:5: teams.a.robots = 6: must be a list"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = [1, 1]\n",
                "night.toml:5: teams.a.robots = [ 1, 1 ]: names robot 1 twice"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = [16]\n", "robots have numbers from 0 to 15"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = []\n", "must name 1 to 6 robots"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nspeed_factor = 1.5\n",
                "night.toml:5: teams.a.speed_factor = 1.5: must be above 0 and at most 1"},
        Mistake{head + teams + "[[conditions]]\n", "conditions.name is missing"},
        Mistake{head + teams + "[[conditions]]\nname = \"x/y\"\n", "conditions.name = 'x/y': use letters"},
        Mistake{head + teams + "[[conditions]]\nname = \"x\"\n[[conditions]]\nname = \"x\"\n",
                "night.toml:12: conditions.name = 'x': another condition"},
        Mistake{
            head + teams + "[[conditions]]\nname = \"x\"\nb.speed_facter = 0.5\n",
            "night.toml:11: unknown key conditions.b.speed_facter = 0.5; known here are: command, name, "}));

TEST(Design, ConditionsChangeTheRealismOfTheDesign) {
  const Design design =
      parse_design(head + "[realism]\npreset = \"harsh\"\nvision.ball_sigma = 0.002\n" + teams +
                       "[[conditions]]\nname = \"as-is\"\n"
                       "[[conditions]]\nname = \"lossy\"\nrealism.radio.loss = 0.1\n"
                       "[[conditions]]\nname = \"clean\"\nrealism = \"none\"\n",
                   "n", check_realism);
  using Changes = std::map<std::string, double>;
  EXPECT_EQ(design.realism.preset, "harsh");
  EXPECT_EQ(design.realism.changes, (Changes{{"vision.ball_sigma", 0.002}}));
  EXPECT_EQ(design.conditions[0].realism, design.realism);
  EXPECT_EQ(design.conditions[1].realism.preset, "harsh");
  EXPECT_EQ(design.conditions[1].realism.changes,
            (Changes{{"radio.loss", 0.1}, {"vision.ball_sigma", 0.002}}));
  EXPECT_EQ(design.conditions[2].realism, (record::RealismConfig{"none", {}}));
  EXPECT_EQ(game(design, 2).config.realism, design.conditions[1].realism);
}

TEST(Design, ThatIsNoFileIsNamed) {
  try {
    read_design("/nowhere/night.toml");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/night.toml: cannot be read"));
  }
}

TEST(CanonicalDesign, DoesNotDependOnHowTheFileIsWritten) {
  const Design one = parse_design("pairs = 2 # two\nname = \"n\"" + teams, "one.toml");
  const Design other =
      parse_design("name = \"n\"\ndescription = \"words\"\ngames = 4\nseed = 1" + teams, "two.toml");
  EXPECT_EQ(canonical(one), canonical(other));
}

TEST(CanonicalDesign, ChangesWithWhatDecidesTheGames) {
  const std::string base = canonical(parse_design("name = \"n\"\npairs = 2" + teams, "n"));
  for (const char* line : {"seed = 2", "realism = \"none\"", "forfeit_goals = 4", "rules.half_length = 30",
                           "rules.winner = true", "realism.radio.loss = 0.1"}) {
    EXPECT_NE(canonical(parse_design("name = \"n\"\npairs = 2\n" + std::string(line) + teams, "n")), base)
        << line;
  }
  EXPECT_NE(canonical(parse_design("name = \"n\"\npairs = 2" + teams + "robots = [0]\n", "n")), base);
}

}  // namespace
}  // namespace schedule
