#include "experiments/schedule/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace schedule {
namespace {

using testing::ElementsAre;

TEST(SplitCommand, SeparatesAtBlanks) {
  EXPECT_THAT(split_command("  team-reference --goalie\t 3 "),
              ElementsAre("team-reference", "--goalie", "3"));
}

TEST(SplitCommand, KeepsWhatIsQuotedTogether) {
  EXPECT_THAT(split_command(R"(python3 'my team.py' "a 'b'" c\ d e"f g"h)"),
              ElementsAre("python3", "my team.py", "a 'b'", "c d", "ef gh"));
}

TEST(SplitCommand, KeepsEmptyWordsThatAreQuoted) {
  EXPECT_THAT(split_command("a '' b"), ElementsAre("a", "", "b"));
}

TEST(SplitCommand, TakesBackslashesInSingleQuotesAsTheyAre) {
  EXPECT_THAT(split_command(R"('a\b')"), ElementsAre(R"(a\b)"));
}

TEST(SplitCommand, RefusesAnOpenQuoteAndNothing) {
  EXPECT_THROW(split_command("team 'half"), std::invalid_argument);
  EXPECT_THROW(split_command("   "), std::invalid_argument);
}

TEST(UsualName, IsTheScriptsWhenAnInterpreterRunsIt) {
  EXPECT_EQ(usual_name({"build/my-team", "x"}), "my-team");
  EXPECT_EQ(usual_name({"/usr/bin/python3.11", "-u", "src/mine.py", "--x"}), "mine.py");
  EXPECT_EQ(usual_name({"python3", "-m", "mine"}), "mine");
  EXPECT_EQ(usual_name({"sh", "-c", "exit 1"}), "sh");
  EXPECT_EQ(usual_name({"python3"}), "python3");
}

TEST(ShellLine, IsReadBackAsTheSameWords) {
  EXPECT_EQ(shell_line({"matchday", "run", "a.toml", "--out=x"}), "matchday run a.toml --out=x");
  EXPECT_EQ(shell_line({"it's", "", "$(touch x)"}), "'it'\\''s' '' '$(touch x)'");
  const std::vector<std::string> words{"`a`", "b c", "d'e'", "\"", "\\", "", "~", "*", "!x", "a\nb"};
  EXPECT_EQ(split_command(shell_line(words)), words);
}

}  // namespace
}  // namespace schedule
