// Designs that somebody else may have written: what is too long, too deep, too large or would act elsewhere
// is one sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <ostream>

#include "experiments/schedule/design.h"
#include "experiments/schedule/toml_depth.h"

namespace schedule {
namespace {

using testing::HasSubstr;

std::string complaint(const std::string& text) {
  try {
    parse_design(text, "night.toml");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

const std::string teams = "[teams.a]\ncommand = \"a\"\n[teams.b]\ncommand = \"b\"\n";
const std::string one_pair = "name = \"n\"\npairs = 1\n" + teams;
const std::string two_pairs = "name = \"n\"\npairs = 2\n" + teams;
const std::string from_git = "name = \"n\"\npairs = 1\n[teams.b]\ncommand = \"b\"\n[teams.a]\nrun = \"a\"\n";

std::string repeated(const std::string& piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

struct Limit {
  std::string text;
  std::string message;
};
void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.message; }

class DesignLimit : public testing::TestWithParam<Limit> {};

TEST_P(DesignLimit, IsOneSentence) {
  const std::string said = complaint(GetParam().text);
  EXPECT_THAT(said, HasSubstr(GetParam().message));
  EXPECT_EQ(said.find('\n'), std::string::npos);
}

const std::string x101(101, 'x');

INSTANTIATE_TEST_SUITE_P(
    Names, DesignLimit,
    testing::Values(Limit{"name = \"" + x101 + "\"\npairs = 1\n" + teams,
                          "name = '" + std::string(59, 'x') + "...: has 101 characters"},
                    Limit{one_pair + "[[conditions]]\nname = \"" + x101 + "\"\n",
                          "has 101 characters; names have at most 100"},
                    Limit{"name = \"n\"\npairs = 1\n[teams.a]\nname = \"" + x101 + "\"\ncommand = \"a\"\n",
                          "has 101 characters"},
                    Limit{"name = \"n\"\npairs = 1\n[teams.a]\nname = \"a\\u001b[2J\"\ncommand = \"a\"\n",
                          "without control characters"},
                    Limit{"name = \"n\"\npairs = 1\n[teams.a]\nname = \"a\\u202e\"\ncommand = \"a\"\n",
                          "without control characters"},
                    Limit{one_pair + "[[sweeps]]\nname = \"s\"\na.flags.x = [\"" + x101 + "\", \"y\"]\n",
                          "makes a condition whose name has 103"},
                    Limit{one_pair + "[[conditions]]\nname = \"../x\"\n", "use letters"},
                    Limit{one_pair + "[[conditions]]\nname = \".x\"\n", "use letters"},
                    Limit{"description = \"" + std::string(10'001, 'x') + "\"\n" + one_pair,
                          "has more than 10000 bytes"}));

INSTANTIATE_TEST_SUITE_P(
    Git, DesignLimit,
    testing::Values(
        Limit{from_git + "repository = \"--upload-pack=touch x\"\nrevision = \"main\"\n",
              "must not begin with '-'"},
        Limit{from_git + "repository = \"ext::sh -c touch% x\"\nrevision = \"main\"\n",
              "must be a path or an address"},
        Limit{from_git + "repository = \".\"\nrevision = \"--output=x\"\n", "must not begin with '-'"},
        Limit{from_git + "repository = \".\"\nrevision = \"a\\tb\"\n", "must not have control characters"}));

INSTANTIATE_TEST_SUITE_P(
    Stopping, DesignLimit,
    testing::Values(
        Limit{one_pair + "[stopping]\nrule = \"sequential\"\n",
              "stopping.rule = 'sequential': needs at least two pairs"},
        Limit{one_pair + "[stopping]\nrule = \"precision\"\nstandard_error = 1\n",
              "needs at least two pairs"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nminimum_pairs = 3\n", "must be from 2 to 2"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nminimum_pairs = 1\n", "must be from 2 to 2"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nbatch_pairs = 0\n", "must be from 1 to 2"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nh0 = 0.2\nh1 = 0.2\n", "h0 must be below h1"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nh0 = 0.2\nh1 = 0.20000000000000004\n",
              "by at least 0.001"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nh1 = nan\n", "must be from -10 to 10"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nh1 = inf\n", "must be from -10 to 10"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nalpha = 0.0\n", "must be above 0"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nalpha = 5e-324\n", "must be at least 0.000001"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nbeta = nan\n", "must be above 0"},
        Limit{two_pairs + "[stopping]\nrule = \"sequential\"\nclip = 0\n", "must be above 0"},
        Limit{two_pairs + "[stopping]\nrule = \"precision\"\nstandard_error = nan\n", "must be above 0"},
        Limit{two_pairs + "[rules]\nhalf_length = nan\n", "must be from 1 to 1100"},
        Limit{two_pairs + "[limits]\ngame = inf\n", "must be above 0"}));

constexpr int depth = 40'000;

INSTANTIATE_TEST_SUITE_P(
    Depth, DesignLimit,
    testing::Values(
        Limit{"x = " + repeated("[", depth) + repeated("]", depth), "night.toml:1: tables or lists are more"},
        Limit{one_pair + "x = " + repeated("{x = ", depth) + "1" + repeated("}", depth), "more than 32 deep"},
        Limit{one_pair + "[" + repeated("x.", depth) + "x]\n", "night.toml:7: tables or lists"},
        Limit{one_pair + repeated("x . ", depth) + "x = 1\n", "more than 32 deep"},
        Limit{one_pair + repeated("\"x\".", depth) + "x = 1\n", "more than 32 deep"},
        Limit{one_pair + "[[" + repeated("x.", depth) + "x]]\n", "more than 32 deep"},
        Limit{one_pair + repeated("'''x'''.", depth) + "x = 1\n", "more than 32 deep"}));

TEST(TooDeep, CountsNeitherTextsNorComments) {
  EXPECT_FALSE(too_deep("a = \"" + repeated("[.", 100) + "\" # " + repeated("[.", 100)));
  EXPECT_FALSE(too_deep("a = '''\n" + repeated("[.\n", 100) + "'''''\nb = \"\"\"" + repeated("\\\"[.", 100) +
                        "\"\"\""));
  EXPECT_FALSE(too_deep("a = [" + repeated("0.5, ", 100) + "]\n" + repeated("b.c = 1.5\n", 100)));
  EXPECT_EQ(too_deep("a = \"\"\"\n\n\"\"\"\nb = ''\n" + repeated("[", 33)), 5U);
}

TEST(Design, FilesOfAbsurdSizeAreRefused) {
  std::string name = (std::filesystem::temp_directory_path() / "limits-test-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const std::filesystem::path file = std::filesystem::path(name) / "night.toml";
  std::ofstream(file) << one_pair << std::string(std::size_t{2} << 20, '#');
  try {
    read_design(file.string());
    ADD_FAILURE() << "nothing thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string() + ": has more than 1 MiB"));
  }
  std::filesystem::remove_all(name);
}

TEST(Design, ALongNameOfAProgramIsShortened) {
  const Design design = parse_design("name = \"n\"\npairs = 1\n[teams.a]\ncommand = \"" +
                                         std::string(200, 'x') + "\"\n[teams.b]\ncommand = \"b\"\n",
                                     "night.toml");
  EXPECT_EQ(design.conditions[0].a.name, std::string(97, 'x') + "...");
}

}  // namespace
}  // namespace schedule
