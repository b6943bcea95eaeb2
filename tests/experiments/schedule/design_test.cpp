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
        Mistake{head + "sed = 1" + teams,
                "night.toml:3: unknown key sed = 1; did you mean seed?; known here are: name, "},
        Mistake{head + "realism = \"real\"" + teams,
                "night.toml:3: realism \"real\" is not known; known are none, friendly"},
        Mistake{head + "[realism]\npreset = 3" + teams, "night.toml:4: realism.preset = 3: must be a text"},
        Mistake{head + "[realism]\nvision.ball_sigma = \"x\"" + teams,
                "night.toml:4: realism.vision.ball_sigma = 'x': must be a number"},
        Mistake{head + "[realism]\n[realism.vision]\nball_sigma = 5" + teams,
                "night.toml:5: realism vision.ball_sigma = 5: must be from 0 to 0.1 m"},
        Mistake{head + "[realism]\nvision.ball_sigma = 9007199254740993" + teams,  // no double is this
                "night.toml:4: realism vision.ball_sigma = 9007199254740992: must be from"},
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
        // A misspelt key that must be there is named with its line, not the one that is missing.
        Mistake{"name = \"n\"\npears = 1\n" + teams,
                "night.toml:2: unknown key pears = 1; did you mean pairs?"},
        Mistake{"name = \"n\"\ngamse = 2\n" + teams,
                "night.toml:2: unknown key gamse = 2; did you mean games?"},
        Mistake{head + "[teams.a]\ncomand = \"x\"\n",
                "night.toml:4: unknown key teams.a.comand = 'x'; did you mean command?"},
        Mistake{head + "[team.a]\ncommand = \"x\"\n", "unknown key team = {...}; did you mean teams?"},
        Mistake{head + "[teams.a]\nname = \"x\"\n", "night.toml:3: teams.a.command is missing"},
        Mistake{head + "[teams.a]\ncommand = []\n", "night.toml:4: teams.a.command = []: must begin with"},
        Mistake{head + "[teams.a]\ncommand = \"x 'y\"\n",
                "night.toml:4: teams.a.command = \"x 'y\": command"},
        Mistake{head + "[teams.a]\ncommand = [1]\n",
                "night.toml:4: teams.a.command = [ 1 ]: must be a list of texts"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = 7\n",
                "night.toml:5: teams.a.robots = 7: must be from 1 to 6, or a list"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = \"6\"\n",
                "night.toml:5: teams.a.robots = '6': must be a list"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = [1, 1]\n",
                "night.toml:5: teams.a.robots = [ 1, 1 ]: names robot 1 twice"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = [16]\n", "robots have numbers from 0 to 15"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrobots = []\n", "must name 1 to 6 robots"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nspeed_factor = 1.5\n",
                "night.toml:5: teams.a.speed_factor = 1.5: must be above 0 and at most 1"},
        Mistake{head + "[rules]\nset = \"papr\"" + teams,
                "there is no such one; did you mean paper?; known are"},
        Mistake{head + "[teams.a]\nrepository = \".\"\nrun = \"./x\"\n", "teams.a.revision is missing"},
        Mistake{head + "[teams.a]\nrepository = \".\"\nrevision = \"main\"\n", "teams.a.run is missing"},
        Mistake{head + "[teams.a]\ncommand = \"x\"\nrevision = \"main\"\n",
                "night.toml:5: teams.a.revision = 'main': belongs to a team from git"},
        Mistake{head + "[teams.a]\nrepository = \".\"\nrevision = \"main\"\ncommand = \"x\"\n",
                "night.toml:6: teams.a.command = 'x': this team is built from git"},
        Mistake{head + teams + "[[sweeps]]\nname = \"s\"\nb.robots = 3\n",
                "night.toml:10: sweeps.name = 's': sweeps nothing"},
        Mistake{head + teams + "[[sweeps]]\nname = \"s\"\nb.speed_factor = []\n",
                "night.toml:11: sweeps.b.speed_factor = []: must have at least one value"},
        Mistake{head + teams + "[[sweeps]]\nname = \"s\"\nb.speed_factor = [0.5,\n2]\n",
                "night.toml:12: sweeps.b.speed_factor = 2: must be above 0"},
        Mistake{head + teams + "[[sweeps]]\nname = \"s\"\nb.robots = [1, 7]\n",
                "night.toml:11: sweeps.b.robots = 7: must be from 1 to 6"},
        Mistake{head + teams + "[[sweeps]]\nname = \"s\"\nrealism.vision.dely = [1, 2]\n",
                "did you mean vision.delay?"},
        Mistake{head + teams + "[[sweeps]]\nname = \"s\"\nb.speed_factor = [1, 1]\n",
                "night.toml:10: sweeps.name = 's': another condition has the name 's-1' already"},
        Mistake{head + teams + "[panel]\n", "panel.opponents is missing"},
        Mistake{head + teams + "[[panel.opponents]]\nname = \"x\"\n", "panel.opponents.command is missing"},
        Mistake{head + teams + "[stopping]\n", "stopping.rule is missing; give fixed, precision"},
        Mistake{head + teams + "[stopping]\nrule = \"sequental\"\n",
                "night.toml:10: stopping.rule = 'sequental': there is no such one; did you mean sequential?"},
        Mistake{head + teams + "[stopping]\nrule = \"precision\"\n", "stopping.standard_error is missing"},
        Mistake{head + teams + "[stopping]\nrule = \"sequential\"\nh0 = 0.3\n",
                "night.toml:11: stopping.h0 = 0.3: h0 must be below h1"},
        Mistake{head + teams + "[stopping]\nrule = \"sequential\"\nalpha = 0.5\n",
                "night.toml:11: stopping.alpha = 0.5: must be above 0 and below 0.5"},
        Mistake{head + teams + "[stopping]\nrule = \"sequential\"\nh1 = 11\n",
                "night.toml:11: stopping.h1 = 11: must be from -10 to 10"},
        Mistake{head + teams + "[stopping]\nrule = \"sequential\"\nmetric = \"points\"\nclip = 3\n",
                "night.toml:12: stopping.clip = 3: is for the goal difference"},
        Mistake{head + teams + "[stopping]\nrule = \"sequential\"\nmetric = \"points\"\nh1 = 2.5\n",
                "night.toml:12: stopping.h1 = 2.5: must be from -2 to 2 for points"},
        Mistake{head + teams + "[stopping]\nrule = \"fixed\"\nalpha = 0.1\n", "unknown key stopping.alpha"},
        Mistake{head + teams + "[limits]\nteam_memory = 0\n",
                "night.toml:10: limits.team_memory = 0: must be from 1 to"},
        Mistake{head + teams + "[limits]\nteam_second = 30\n",
                "night.toml:10: limits.team_second = 30: two teams may then take 60 s, and after 60 s "
                "(silence) the "
                "game is void: must be below half of it"},
        Mistake{head + teams + "[limits]\nsilence = 30\nteam_second = 20\n",
                "and after 30 s (silence) the game"},
        Mistake{head + teams + "[limits]\nteam_game = 1800\n",
                "two teams may then take 3600 s, and after 3600 s (game) the game is void"},
        Mistake{
            head + teams + "[limits]\nteam_second = 3\nteam_reply = 4\n",
            "limits.team_reply = 4: is more than the 3 s allowed for a whole simulated second (team_second)"},
        Mistake{head + teams + "[limits]\nteam_reply = 0\n", "limits.team_reply = 0: must be above 0"},
        Mistake{head + teams + "[limits]\nsampled = 2\n", "limits.sampled = 2: must be from 0 to 1"},
        Mistake{head + teams + "[limits]\nsilense = 2\n", "did you mean silence?"},
        Mistake{head + teams + "[[conditions]]\n", "conditions.name is missing"},
        Mistake{head + teams + "[[conditions]]\nname = \"x/y\"\n", "conditions.name = 'x/y': use letters"},
        Mistake{head + teams + "[[conditions]]\nname = \"x\"\n[[conditions]]\nname = \"x\"\n",
                "night.toml:12: conditions.name = 'x': another condition"},
        Mistake{head + teams + "[[conditions]]\nname = \"x\"\nb.speed_facter = 0.5\n",
                "night.toml:11: unknown key conditions.b.speed_facter = 0.5; did you mean speed_factor?"}));

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

std::vector<std::string> names(const Design& design) {
  std::vector<std::string> names;
  for (const Condition& condition : design.conditions) names.push_back(condition.name);
  return names;
}

TEST(Design, SweepsAreWrittenOutAsAGridWithTheLastListRunningFastest) {
  const Design design = parse_design(head + teams + R"([[sweeps]]
name = "press"
b.robots = [1, [0, 3]]
a.flags."--press" = [0.25, "off"]
a.speed_factor = 0.5
)",
                                     "n");
  EXPECT_THAT(names(design), ElementsAre("press-1-0.25", "press-1-off", "press-2-0.25", "press-2-off"));
  const Condition& first = design.conditions[0];
  EXPECT_EQ(first.sweep, "press");
  EXPECT_THAT(first.a.command, ElementsAre("team-reference", "--press", "--press=0.25"));
  EXPECT_EQ(first.a.speed_factor, 0.5);
  EXPECT_THAT(first.b.robots, ElementsAre(0));
  EXPECT_EQ(first.values, (std::map<std::string, double>{{"a.--press", 0.25}, {"b.robots", 1}}));
  const Condition& last = design.conditions[3];
  EXPECT_THAT(last.a.command, ElementsAre("team-reference", "--press", "--press=off"));
  EXPECT_THAT(last.b.robots, ElementsAre(0, 3));
  EXPECT_EQ(last.values, (std::map<std::string, double>{{"b.robots", 2}})) << "a text has no number";
}

TEST(Design, SweepsTakeRealismFlagsOfSeveralWordsAndLists) {
  const Design design = parse_design(head + teams + R"([[conditions]]
name = "plain"
[[sweeps]]
name = "noise"
realism.vision.ball_sigma = [0.001, 0.002]
[[sweeps]]
name = "world"
realism = ["none", "harsh"]
[[sweeps]]
name = "words"
b.flags."--number {}" = [-3]
b.arguments = [["-x"], ["-y", "-z"]]
)",
                                     "n", check_realism);
  EXPECT_THAT(names(design), ElementsAre("plain", "noise-0.001", "noise-0.002", "world-none", "world-harsh",
                                         "words--3-1", "words--3-2"));
  EXPECT_EQ(design.conditions[2].realism.changes.at("vision.ball_sigma"), 0.002);
  EXPECT_EQ(design.conditions[2].values,
            (std::map<std::string, double>{{"realism.vision.ball_sigma", 0.002}}));
  EXPECT_EQ(design.conditions[4].realism.preset, "harsh");
  EXPECT_THAT(design.conditions[6].b.command,
              ElementsAre("team-chaser", "--slow", "very much", "-y", "-z", "--number", "-3"));
  EXPECT_TRUE(design.conditions[0].sweep.empty());
}

TEST(Design, APanelIsMetByBothInTheSamePairsWithTheSameSeeds) {
  const Design design = parse_design(head + teams + R"([panel]
head_to_head = true
[[panel.opponents]]
name = "x"
command = "team-x"
[[panel.opponents]]
command = "team-y"
robots = 3
)",
                                     "n");
  EXPECT_THAT(names(design), ElementsAre("a-vs-b", "a-vs-x", "b-vs-x", "a-vs-team-y", "b-vs-team-y"));
  EXPECT_FALSE(design.conditions[0].panel);
  EXPECT_EQ(design.conditions[2].panel, (PanelPlace{"base", "x", 'b'}));
  EXPECT_EQ(design.conditions[1].a.name, "ours");
  EXPECT_EQ(design.conditions[2].a.name, "team-chaser");
  EXPECT_EQ(design.conditions[4].b.name, "team-y");
  EXPECT_THAT(design.conditions[4].b.robots, ElementsAre(0, 1, 2));
  const record::MatchConfig one = game(design, 2).config;
  const record::MatchConfig other = game(design, 4).config;
  EXPECT_EQ(one.seed, other.seed);
  EXPECT_EQ(one.blue_on_positive_half, other.blue_on_positive_half);
  EXPECT_EQ(one.teams.yellow, other.teams.yellow) << "the same opponent";
}

TEST(Design, APanelMultipliesTheConditions) {
  const Design design = parse_design(head + teams + R"([[conditions]]
name = "slow"
a.speed_factor = 0.5
b.speed_factor = 0.6
[[conditions]]
name = "fast"
[[panel.opponents]]
command = "team-x"
)",
                                     "n");
  EXPECT_THAT(names(design),
              ElementsAre("slow-a-vs-team-x", "slow-b-vs-team-x", "fast-a-vs-team-x", "fast-b-vs-team-x"));
  EXPECT_EQ(design.conditions[1].a.speed_factor, 0.6) << "b's changes go with b";
  EXPECT_EQ(design.conditions[1].b.speed_factor, 1) << "an opponent is as it is";
}

TEST(Design, ReadsTeamsFromGit) {
  const Design design = parse_design(R"(name = "n"
pairs = 1
[teams.a]
repository = "../team"
revision = "main"
build = "make -j4"
run = "bin/team --fast"
[teams.b]
command = "team-chaser"
[[sweeps]]
name = "history"
a.revision = ["v1", "v2"]
)",
                                     "n");
  ASSERT_EQ(design.conditions.size(), 2U);
  EXPECT_EQ(design.conditions[1].a_source, (Source{"../team", "v2", "make -j4"}));
  EXPECT_FALSE(design.conditions[1].b_source);
  EXPECT_EQ(design.conditions[1].a.name, "main");
  EXPECT_THAT(design.conditions[1].a.command, ElementsAre("bin/team", "--fast"));
}

TEST(Design, ReadsStoppingAndLimits) {
  const auto stopping = [](const std::string& text) {
    return parse_design("name = \"n\"\npairs = 400" + teams + "[stopping]\n" + text, "n").stopping;
  };
  EXPECT_EQ(parse_design(head + teams, "n").stopping.rule, StopRule::Fixed);
  const Stopping precision = stopping("rule = \"precision\"\nstandard_error = 0.2\n");
  EXPECT_EQ(precision.rule, StopRule::Precision);
  EXPECT_EQ(precision.standard_error, 0.2);
  EXPECT_EQ(precision.minimum_pairs, 25);
  const Stopping sequential =
      stopping("rule = \"sequential\"\nh0 = -0.1\nh1 = 0\nclip = 5\nbatch_pairs = 2\n");
  EXPECT_EQ(sequential.metric, Metric::GoalDifference);
  EXPECT_EQ(sequential.h0, -0.1);
  EXPECT_EQ(sequential.clip, 5);
  EXPECT_EQ(sequential.minimum_pairs, 8);
  EXPECT_EQ(sequential.batch_pairs, 2);
  const Stopping points = stopping("rule = \"sequential\"\nmetric = \"points\"\n");
  EXPECT_EQ(points.metric, Metric::Points);
  const Limits limits = parse_design(head + teams + "[limits]\nteam_memory = 100\nsilence = 5\n", "n").limits;
  EXPECT_EQ(limits.team_memory, 100);
  EXPECT_EQ(limits.silence, 5);
  EXPECT_EQ(limits.game, Limits{}.game);
  EXPECT_EQ(parse_design(head + teams, "n").limits.team_time, TeamTime{});
  EXPECT_EQ(limits.team_time, (TeamTime{5.0 / 3, 5.0 / 3, 1440})) << "two teams fit into the silence";
}

TEST(CanonicalDesign, KnowsATeamFromGitByItsCommitNotByWhereItIs) {
  Design design = parse_design(
      head +
          "[teams.a]\nrepository = \"x\"\nrevision = \"main\"\nrun = \"./t\"\n[teams.b]\ncommand = \"t\"\n",
      "n");
  Condition& condition = design.conditions.front();
  condition.a_source->commit = std::string(40, 'a');
  const std::string before = canonical(design);
  condition.a.directory = "/elsewhere";
  condition.a_source->repository = "/elsewhere";
  condition.a_source->revision = "other-name";
  EXPECT_EQ(canonical(design), before);
  condition.a_source->commit = std::string(40, 'b');
  EXPECT_NE(canonical(design), before);
}

TEST(CanonicalDesign, HasTheStoppingRuleButNoLimitThatDecidesNoGame) {
  const std::string two = "name = \"n\"\npairs = 2\n";
  const std::string base = canonical(parse_design(two + teams, "n"));
  EXPECT_EQ(canonical(parse_design(two + teams + "[limits]\nsilence = 5\n", "n")), base);
  EXPECT_NE(canonical(parse_design(two + teams + "[limits]\nteam_memory = 5\n", "n")), base);
  EXPECT_EQ(canonical(parse_design(two + teams + "[stopping]\nrule = \"fixed\"\n", "n")), base);
  for (const std::string key : {"team_reply = 1", "team_second = 10", "team_game = 100"}) {
    EXPECT_NE(canonical(parse_design(two + teams + "[limits]\n" + key + "\n", "n")), base) << key;
  }
  const std::string rule = "[stopping]\nrule = \"sequential\"\n";
  const std::string sequential = canonical(parse_design(two + teams + rule, "n"));
  EXPECT_NE(sequential, base);
  EXPECT_NE(canonical(parse_design(two + teams + rule + "metric = \"points\"\n", "n")), sequential);
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

TEST(Design, IsolationIsReadAndChangesNoGame) {
  const Design usual = parse_design(head + teams, "n");
  EXPECT_FALSE(usual.isolation);
  const Design isolated =
      parse_design(head + "isolation = \"files\"\nvisible = [\"/models\"]\n" + teams, "n");
  EXPECT_EQ(isolated.isolation, process::Isolation::Files);
  EXPECT_THAT(isolated.visible, ElementsAre("/models"));
  EXPECT_EQ(canonical(isolated), canonical(usual));
  EXPECT_THAT(complaint(head + "isolation = \"netwrok\"\n" + teams),
              HasSubstr("did you mean network?; known are: none, files, network"));
}

}  // namespace
}  // namespace schedule
