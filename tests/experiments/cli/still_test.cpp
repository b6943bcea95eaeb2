// What every command says of a team that never moves.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "tests/experiments/cli/matchday_program.h"
#include "tests/fakes/programs.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;

// Were its games void, none of them would count.
TEST_F(MatchdayProgram, ATeamThatNeverMovesForfeitsAndEveryCommandSaysSo) {
  const std::string fake = fakes::bin_dir() + "/fake-team --mode ";
  std::ofstream(folder_ / "still.toml") << "name = \"still\"\npairs = 2\n[rules]\nhalf_length = 2.0\n"
                                        << "[teams.a]\ncommand = \"" + fake + "wander\"\n"
                                        << "[teams.b]\nname = \"post\"\ncommand = \"" + fake + "good\"\n";
  const auto sentence = HasSubstr("(post) never told a robot to move");
  const Said run = matchday("run still.toml --no-preflight");
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_THAT(run.text, AllOf(HasSubstr("4 of 4 games"), sentence));
  EXPECT_THAT(matchday("report results/still").text, HasSubstr("0 forfeits by A, 4 by B"));
  EXPECT_THAT(matchday("report results/still --format json").text, HasSubstr("\"b_forfeits\": 4"));
  EXPECT_EQ(matchday("verify results/still").code, 0);
  for (const std::string how : {"", " --recorded"}) {
    const Said again = matchday("replay results/still base-0000-1" + how);
    EXPECT_EQ(again.code, 0) << again.text;
    EXPECT_THAT(again.text, HasSubstr("the same game as in the ledger"));
  }
  const Said first = matchday("run still.toml --out other");
  EXPECT_EQ(first.code, 3);
  EXPECT_THAT(first.text, AllOf(HasSubstr("a short game before the first one failed"), sentence));
}

}  // namespace
