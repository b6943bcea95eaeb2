// The program as its user has it: what it prints and the code it ends with.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/experiments/cli/matchday_program.h"
#include "tests/fakes/programs.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(MatchdayProgram, TellsItsVersionAndExitCodes) {
  EXPECT_THAT(matchday("--version").text, StartsWith("matchday 0."));
  const Said help = matchday("--help");
  EXPECT_EQ(help.code, 0);
  for (const char* word :
       {"play", "plan", "run", "compare", "report", "replay", "bench", "Exit codes: 0 done"}) {
    EXPECT_THAT(help.text, HasSubstr(word));
  }
  EXPECT_THAT(help.text, Not(HasSubstr("worker")));
}

struct Mistake {
  std::string arguments;
  std::string message;
  int code;
};
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.arguments; }

class MatchdayMistake : public MatchdayProgram, public testing::WithParamInterface<Mistake> {};

TEST_P(MatchdayMistake, IsOneSentenceAndItsExitCode) {
  write_design("good.toml");
  write_design("bad.toml", "realism = \"real\"\n");
  std::ofstream(folder_ / "no-team.toml")
      << "name = \"x\"\npairs = 1\n[teams.a]\ncommand = \"no-such-team\"\n"
      << "[teams.b]\ncommand = \"true\"\n";
  const Said said = matchday(GetParam().arguments);
  EXPECT_EQ(said.code, GetParam().code);
  // `run` says what it is about to do before it looks into the result folder.
  const std::string last = said.text.substr(said.text.find("matchday: "));
  EXPECT_THAT(last, AllOf(StartsWith("matchday: "), HasSubstr(GetParam().message)));
  EXPECT_EQ(last.find('\n'), last.size() - 1) << "one line: " << last;
}

INSTANTIATE_TEST_SUITE_P(
    All, MatchdayMistake,
    testing::Values(
        Mistake{"play --blu x", "unknown flag '--blu'; see matchday play --help", 2},
        Mistake{"play --blue true --yellow true --half-length -3", "-3 not in range 1", 2},
        Mistake{"play --blue true --yellow true --half-length 1200", "not in range 1.000000 to 1100", 2},
        Mistake{"play --blue true --yellow true --seed -3", "-3: must be a whole number from 0", 2},
        Mistake{"play --blue true --yellow true --seed 99999999999999999999999", "must be a whole number", 2},
        Mistake{"compare a b --run x --seed 9223372036854775808", "from 0 to 9223372036854775807", 2},
        Mistake{"play --blue true --yellow true --team-logs /proc/no",
                "--team-logs /proc/no: the folder cannot", 2},
        Mistake{"play --blue good.toml --yellow true", "write ./good.toml for the file", 2},
        Mistake{"play --blue ./good.toml --yellow true", "make it one with chmod +x", 2},
        Mistake{"run good.toml --out .", "--out .: holds '", 5}, Mistake{"run", "see matchday run --help", 2},
        Mistake{"", "subcommand", 2},
        Mistake{"dance", "unknown command 'dance'; known are: play, continue, run", 2},
        Mistake{"run good.toml --fast", "--fast", 2}, Mistake{"run", "design is required", 2},
        Mistake{"run nothing.toml", "nothing.toml: cannot be read", 2}, Mistake{"run .", ".: is a folder", 2},
        Mistake{"run bad.toml", "bad.toml:2: realism \"real\" is not known; known are none", 2},
        Mistake{"run good.toml --workers 0", "--workers", 2},
        Mistake{"run no-team.toml", "no-team.toml: condition 'base', team a: program 'no-such-team'", 2},
        Mistake{"run good.toml --out /proc/no", "result folder /proc/no: cannot be made", 5},
        Mistake{"play --blue true", "--yellow is required", 2},
        Mistake{"play --blue no-such-team --yellow true", "--blue: program 'no-such-team'", 2},
        Mistake{"play --blue 'true \"' --yellow true", "--blue: command 'true \"': a \" is not closed", 2},
        Mistake{"play --blue true --yellow true --seed x", "--seed", 2},
        Mistake{"play --blue true --yellow true --rules fifa", "unknown rule set 'fifa'", 2},
        Mistake{"play --blue true --yellow true --realism real", "real", 2},
        Mistake{"play --blue true --yellow true --blue-robots 0,16", "--blue-robots", 2},
        Mistake{"play --blue true --yellow true --blue-robots 1,1", "1", 2},
        Mistake{"play --blue true --yellow true --yellow-speed 0", "--yellow-speed", 2},
        Mistake{"play --blue true --yellow true --half-length -1", "--half-length", 2},
        Mistake{"play --blue true --yellow true --set vision.dela=1", "did you mean vision.delay?", 2},
        Mistake{"play --blue true --yellow true --set vision.delay", "must be a key and a number", 2},
        Mistake{"judge nothing.toml", "nothing.toml: cannot be read", 2},
        Mistake{"judge good.toml --shadow paper", "'paper' is not KEY=VALUE", 2},
        Mistake{"judge good.toml --shadow vision.ball_sigma=7", "vision.ball_sigma", 2},
        Mistake{"judge good.toml --shadow net:", "net:COMMAND", 2},
        Mistake{"judge good.toml --save x", "give --show", 2},
        Mistake{"judge good.toml --show x", "give GAME:FIRST-LAST", 2},
        Mistake{"judge good.toml --games 0", "--games", 2},
        Mistake{"realism bad.toml", "bad.toml:2: realism \"real\" is not known", 2},
        Mistake{"realism none.toml", "none.toml: cannot be read", 2},
        Mistake{"realism --set vision.cameras=3", "1, 2, 4, 6 or 8", 2},
        Mistake{"continue nothing.replies", "nothing.replies: cannot be read", 2},
        Mistake{"continue good.toml", "good.toml: ", 2},
        Mistake{"report . --html --format csv", "excludes --", 2},
        Mistake{"compare a b --run x --h1 nan", "--h1: must be a number", 2},
        Mistake{"compare a b --run x --seed -1", "--seed: -1: must be a whole number from 0", 2},
        Mistake{"report .", "./ledger.sqlite: there is no ledger", 5},
        Mistake{"report nowhere", "nowhere/ledger.sqlite: there is no ledger", 5},
        Mistake{"replay . one-0000-0", "there is no ledger", 5}));

TEST_F(MatchdayProgram, RunsADesignPrintsItsTableAndReportsItAgain) {
  write_design("good.toml");
  const Said run = matchday("run good.toml --workers 2" + fake());
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.text, HasSubstr("8/8 games"));
  EXPECT_THAT(run.text, HasSubstr("realism measured"));
  EXPECT_THAT(run.text, HasSubstr("8 of 8 games"));
  const Said report = matchday("report results/small");
  EXPECT_EQ(report.code, 0);
  EXPECT_THAT(run.text, HasSubstr(report.text));
  EXPECT_THAT(matchday("report results/small --format csv").text,
              StartsWith("forfeits,condition,realism,games"));
  EXPECT_EQ(matchday("report results/small --format xml").code, 2);
  const Said again = matchday("run good.toml --workers 2" + fake());
  EXPECT_EQ(again.code, 0);
  EXPECT_THAT(again.text, HasSubstr(report.text));
}

TEST_F(MatchdayProgram, RefusesAnotherDesignInTheSameFolderNamingBothHashes) {
  write_design("good.toml");
  write_design("other.toml", "seed = 2\n");
  matchday("run good.toml --out here" + fake());
  const Said said = matchday("run other.toml --out here" + fake());
  EXPECT_EQ(said.code, 5);
  EXPECT_THAT(said.text, testing::ContainsRegex("holds experiment [0-9a-f]+ but the design.* [0-9a-f]+;"));
}

TEST_F(MatchdayProgram, EndsWithAnErrorWhenTooManyGamesAreVoid) {
  write_design("good.toml");
  const Said said = matchday("run good.toml --no-preflight" + fake("--fail always --how exit"));
  EXPECT_EQ(said.code, 4);
  EXPECT_THAT(said.text,
              HasSubstr("5 games in a row were void (the last: the worker ended with code 3): stopped"));
  EXPECT_THAT(said.text, HasSubstr("no game counts yet"));
  EXPECT_THAT(said.text,
              HasSubstr("when it is mended, continue with: " + fakes::bin_dir() + "/matchday run good.toml"));
}

TEST_F(MatchdayProgram, EndsBeforeTheFirstGameWhenTheTeamsCannotPlay) {
  write_design("good.toml");
  const Said said = matchday("run good.toml");  // the teams are `true`, which does not connect
  EXPECT_EQ(said.code, 3);
  EXPECT_THAT(said.text, HasSubstr("a short game before the first one failed: condition 'one': "));
  EXPECT_THAT(said.text, HasSubstr("ended with code 0 before it connected"));
  EXPECT_THAT(matchday("report results/small").text, HasSubstr("no game counts yet"));
}

// 0.54 s for a simulated second, each reply far below what it may take.
TEST_F(MatchdayProgram, ASlowTeamForfeitsItsGamesWithTheNumberAndTheNightGoesOn) {
  const std::string fake = fakes::bin_dir() + "/fake-team --mode ";
  const std::string slow = fake + "late --milliseconds 9";
  std::ofstream(folder_ / "slow.toml") << "name = \"slow\"\npairs = 2\n[rules]\nhalf_length = 2.0\n"
                                       << "[limits]\nteam_second = 0.25\nteam_reply = 0.2\n"
                                       << "[teams.a]\ncommand = \"" + fake + "wander\"\n"
                                       << "[teams.b]\nname = \"snail\"\ncommand = \"" + slow + "\"\n";
  const auto number = AllOf(HasSubstr("(snail) used "), HasSubstr(", 0.25 s are allowed"));
  const Said run = matchday("run slow.toml --no-preflight");
  EXPECT_EQ(run.code, 0) << run.text;
  EXPECT_THAT(run.text, AllOf(HasSubstr("4 of 4 games"), number));

  const Said first = matchday("run slow.toml --out other");
  EXPECT_EQ(first.code, 3);
  EXPECT_THAT(first.text, AllOf(HasSubstr("a short game before the first one failed"), number));
  fs::remove_all(folder_ / "results");
  const Said plan = matchday("plan slow.toml");
  EXPECT_EQ(plan.code, 2);
  EXPECT_THAT(plan.text,
              AllOf(HasSubstr("the short game that measures the pace ended by a fault: "), number));
  const Said play = matchday("play --blue '" + slow + "' --yellow '" + fake + "wander' --team-second 0.25");
  EXPECT_EQ(play.code, 4);
  EXPECT_THAT(play.text, HasSubstr(" s of its own time for simulated second "));
  for (const char* command : {"run", "plan"}) {
    EXPECT_THAT(matchday(std::string(command) + " --help").text,
                AllOf(HasSubstr("team_reply"), HasSubstr("team_second"), HasSubstr("team_game")));
  }
}

TEST_F(MatchdayProgram, ReplaysAFaultyGameFromItsRepliesWithoutTheTeams) {
  std::ofstream(folder_ / "real.toml")
      << "name = \"real\"\npairs = 1\n[rules]\nhalf_length = 5.0\n"
      << "[teams.a]\ncommand = [\"" + fakes::bin_dir() + "/fake-team\", \"--mode\", \"wander\"]\n"
      << "[teams.b]\ncommand = [\"" + fakes::bin_dir() +
             "/fake-team\", \"--mode\", \"crash\", \"--at\", \"400\"]\n";
  EXPECT_EQ(matchday("run real.toml --no-preflight").code, 0) << "forfeits count";
  for (const std::string how : {" --isolation none", " --recorded"}) {
    const Said said = matchday("replay results/real base-0000-1" + how);
    EXPECT_EQ(said.code, 0) << said.text;
    EXPECT_THAT(said.text, HasSubstr("the same game as in the ledger"));
  }
  // A recording of another game is noticed.
  fs::copy_file(folder_ / "results/real/games/base-0000-0/1/game.replies",
                folder_ / "results/real/games/base-0000-1/1/game.replies",
                fs::copy_options::overwrite_existing);
  const Said swapped = matchday("replay results/real base-0000-1 --recorded");
  EXPECT_EQ(swapped.code, 2);
  EXPECT_THAT(swapped.text, HasSubstr("is the recording of another game than base-0000-1"));
  fs::remove_all(folder_ / "results/real/games");
  const Said gone = matchday("replay results/real base-0000-1 --recorded");
  EXPECT_EQ(gone.code, 2);
  EXPECT_THAT(gone.text, HasSubstr("only those of faulty and sampled games are"));
}

TEST_F(MatchdayProgram, JudgePrintsTheSummaryAndForgetsNoGameWhenFewerAreAskedFor) {
  const std::string team = "command = [\"" + fakes::bin_dir() + "/fake-team\", \"--mode\", \"wander\"]\n";
  std::ofstream(folder_ / "real.toml")
      << "name = \"real\"\npairs = 1\n[rules]\nhalf_length = 2.0\n[teams.a]\n"
      << team << "[teams.b]\n"
      << team;
  const Said two = matchday("judge real.toml");
  EXPECT_EQ(two.code, 0) << two.text;
  EXPECT_THAT(two.text, HasSubstr("2 of 2 games"));
  EXPECT_THAT(two.text, HasSubstr("| last team |"));
  EXPECT_THAT(two.text, HasSubstr("All tables: results/judge-real/judge.md."));
  EXPECT_THAT(two.text, Not(HasSubstr("## b) Last touching team")));  // in judge.md only
  EXPECT_THAT(matchday("judge real.toml --games 1").text, HasSubstr("2 of 2 games"));
  fs::remove(folder_ / "results/judge-real/games/base-0000-1.jsonl");
  EXPECT_THAT(matchday("judge real.toml --games 1").text, HasSubstr("1 of 1 games"));
  std::ostringstream report;
  report << std::ifstream(folder_ / "results/judge-real/judge.md").rdbuf();
  EXPECT_THAT(report.str(), HasSubstr("## b) Last touching team"));
  EXPECT_THAT(report.str(), HasSubstr("*Band*: 40 mm"));
}

TEST_F(MatchdayProgram, TellsHowToContinueAfterTroubleWithTheFolder) {
  write_design("good.toml");
  const Said said = matchday("run good.toml --out /dev/full" + fake());
  EXPECT_EQ(said.code, 5);
  EXPECT_THAT(said.text, HasSubstr("continue with: "));
}

TEST_F(MatchdayProgram, InterruptedSaysHowToContinue) {
  write_design("good.toml");
  const std::string line = "run good.toml --out 'my results' --no-preflight" + fake("--milliseconds 5000");
  const std::string text = shell("timeout -s INT 2 \"$BIN\"/matchday " + line).text;
  EXPECT_THAT(text,
              HasSubstr("continue with: " + fakes::bin_dir() + "/matchday run good.toml --out 'my results'"));
}

TEST_F(MatchdayProgram, ReplayWantsAGameOfTheFolder) {
  write_design("good.toml");
  matchday("run good.toml" + fake());
  const Said said = matchday("replay results/small one-0009-0");
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.text,
              HasSubstr("design 'small' has no game 'one-0009-0'; games are named like 'one-0000-0'"));
}

TEST_F(MatchdayProgram, EndsWithTheVerdictOfASequentialTest) {
  const auto verdict = [&](const std::string& name, const std::string& a, const std::string& b,
                           const std::string& h1) {
    std::ofstream(folder_ / (name + ".toml")) << "name = \"" << name << "\"\npairs = 30"
                                              << "\n[teams.a]\nname = \"new\"\ncommand = \"true goals=" << a
                                              << "\"\n[teams.b]\nname = \"old\"\ncommand = \"true goals=" << b
                                              << "\"\n[stopping]\nrule = \"sequential\"\nh1 = " << h1 << "\n";
    return matchday("run " + name + ".toml --worker " + fakes::bin_dir() + "/coin_worker");
  };
  const Said better = verdict("better", "5", "1", "0.5");
  EXPECT_EQ(better.code, 0);
  EXPECT_THAT(better.text,
              AllOf(HasSubstr("stopping: sequential test of A's goal difference: H0 0 against H1 0.5"),
                    HasSubstr("base: A (new) against B (old), goal difference: H1 accepted"),
                    HasSubstr("estimate corrected for the stopping +")));
  EXPECT_EQ(verdict("worse", "1", "3", "0.5").code, 10);
  EXPECT_EQ(verdict("short", "1.3", "1", "0.01").code, 11);
  EXPECT_THAT(matchday("report results/better").text, HasSubstr("H1 accepted"));
}

TEST_F(MatchdayProgram, PlansFromTheGamesOfAnEarlierRun) {
  std::ofstream(folder_ / "night.toml")
      << "name = \"night\"\npairs = 40\n[teams.a]\ncommand = \"true goals=2\"\n"
      << "[teams.b]\ncommand = \"true goals=1\"\n";
  matchday("run night.toml --worker " + fakes::bin_dir() + "/coin_worker");
  const Said plan = matchday("plan night.toml --workers 2");
  EXPECT_EQ(plan.code, 0);
  EXPECT_THAT(plan.text, AllOf(HasSubstr("night: 1 condition x 40 pairs x 2 games = 80 games"),
                               HasSubstr("2 at a time"), HasSubstr("measured: 80 games in results/night"),
                               HasSubstr("stopping: fixed number: 40 pairs per condition"),
                               HasSubstr("seen in 80 games")));
}

TEST_F(MatchdayProgram, PlanSaysWhyItCouldNotMeasure) {
  write_design("good.toml");
  const Said plan = matchday("plan good.toml");
  EXPECT_EQ(plan.code, 2);
  EXPECT_THAT(plan.text, HasSubstr("the short game that measures the pace ended by a fault: "));
}

TEST_F(MatchdayProgram, RefusesADamagedRecordingBeforeItPlaysAnyOfIt) {
  const std::string team = "\"$BIN/fake-team --mode wander\"";
  const Said played =
      matchday("play --half-length 1 --blue " + team + " --yellow " + team + " --record game.replies");
  ASSERT_EQ(played.code, 0) << played.text;
  {
    std::fstream file(folder_ / "game.replies", std::ios::in | std::ios::out | std::ios::binary);
    const auto middle = static_cast<std::streamoff>(fs::file_size(folder_ / "game.replies") / 2);
    file.seekg(middle);
    const int byte = file.get();
    file.seekp(middle);
    file.put(static_cast<char>(byte ^ 1));
  }
  const Said said = matchday("continue game.replies");
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.text, AllOf(HasSubstr("game.replies: record "), Not(HasSubstr("internal error"))));
}

TEST_F(MatchdayProgram, RefusesADamagedOrSwappedRecordingOfAResultFolder) {
  std::ofstream(folder_ / "d.toml") << "name = \"d\"\npairs = 1\n[rules]\nhalf_length = 2\n"
                                    << "[limits]\nsampled = 1.0\naudited = 0.0\n"
                                    << "[teams.a]\ncommand = \"fake-team --mode wander\"\n"
                                    << "[teams.b]\ncommand = \"fake-team --mode wander\"\n";
  matchday("run d.toml --out r --no-preflight");
  // The last attempt: fake teams may play no game that counts.
  const auto recording = [&](const std::string& game) {
    fs::path last;
    for (const std::string number : {"1", "2", "3"}) {
      const fs::path file = folder_ / "r/games" / game / number / "game.replies.gz";
      if (fs::exists(file)) last = file;
    }
    return last;
  };
  const fs::path file = recording("base-0000-0");
  ASSERT_FALSE(file.empty());
  const auto refused = [&](const std::string& sentence) {
    const Said said = matchday("replay r base-0000-0 --recorded");
    EXPECT_EQ(said.code, 2) << said.text;
    EXPECT_THAT(said.text, AllOf(StartsWith("matchday: "), HasSubstr("game.replies.gz: " + sentence)));
  };
  fs::copy_file(recording("base-0000-1"), file, fs::copy_options::overwrite_existing);
  refused("is the recording of another game than base-0000-0: ");
  fs::resize_file(file, 10);
  refused("");
  const Said verified = matchday("verify r");
  EXPECT_EQ(verified.code, 5);
  EXPECT_THAT(verified.text,
              AllOf(HasSubstr("game.replies.gz has 10 bytes"), Not(HasSubstr("internal error"))));
  std::ofstream(file, std::ios::trunc) << "";
  refused("");
}

// The teams never connect, so that the signal comes while the host waits for them.
TEST_F(MatchdayProgram, PlanEndsBySignalAsEveryCommandDoes) {
  const std::string silent = "command = \"" + fakes::bin_dir() + "/fake-team --mode never-connect\"\n";
  std::ofstream(folder_ / "silent.toml") << "name = \"silent\"\npairs = 1\n[teams.a]\n"
                                         << silent << "[teams.b]\n"
                                         << silent;
  const Said plan = shell("timeout --preserve-status -s INT 1 \"$BIN\"/matchday plan silent.toml");
  EXPECT_EQ(plan.code, 130);
  EXPECT_THAT(plan.text, Not(HasSubstr("mend that first")));
}

// The whole way of a limit: design, runner, worker, host, log. The team prints 1.2 MB a simulated second and
// never moves, so its games are void and their files are kept.
TEST_F(MatchdayProgram, KeepsOfATeamsOutputWhatTheDesignSays) {
  std::ofstream(folder_ / "talk.toml")
      << "name = \"talk\"\npairs = 1\n[rules]\nhalf_length = 2.0\n[limits]\noutput = 1\n"
      << "[teams.a]\ncommand = \"" + fakes::bin_dir() + "/fake-team --mode chatter\"\n"
      << "[teams.b]\ncommand = \"" + fakes::bin_dir() + "/fake-team --mode chatter\"\n";
  EXPECT_EQ(matchday("run talk.toml --no-preflight --workers 1").code, 4);
  const auto size = fs::file_size(folder_ / "results/talk/games/base-0000-0/1/blue.log");
  EXPECT_GE(size, 1U << 20);
  EXPECT_LT(size, (1U << 20) + (64U << 10)) << "and a sentence that there was more";
}

TEST_F(MatchdayProgram, ComparesTwoRevisionsInOneCommandAndContinues) {
  const std::string git = "git -c user.name=test -c user.email=test@example.org ";
  ASSERT_EQ(
      shell(
          "git init -q -b main team && cd team && printf '#!/bin/sh\\necho 1\\n' > t.sh && chmod +x t.sh && "
          "git add -A && " +
          git + "commit -qm one && git checkout -q -b fast && echo '# 2' >> t.sh && " + git +
          "commit -qam two")
          .code,
      0);
  const std::string line =
      "compare main fast --team-repo team --build 'mkdir bin && cp t.sh bin/' --run 'bin/t.sh goals=2' "
      "--games 12 --worker " +
      fakes::bin_dir() + "/coin_worker";
  const Said first = matchday(line);
  EXPECT_EQ(first.code, 0) << first.text;
  EXPECT_THAT(first.text, AllOf(HasSubstr("building fast (commit "), HasSubstr("A fast"), HasSubstr("B main"),
                                HasSubstr("12 of 12 games")));
  const Said again = matchday(line);
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_THAT(again.text, AllOf(Not(HasSubstr("building")), HasSubstr("12 of 12 games are there")));
  EXPECT_EQ(
      shell(
          "ls results/compare-main-fast-*/manifest.json && grep -q bin/t.sh results/compare-*/manifest.json")
          .code,
      0);

  const Said missing = matchday("compare main fest --team-repo team --run bin/t.sh");
  EXPECT_EQ(missing.code, 2);
  EXPECT_THAT(missing.text,
              HasSubstr("team A: repository 'team': has no revision 'fest'; did you mean fast?"));
  const Said broken = matchday(
      "compare main fast --team-repo team --build 'echo no compiler; exit 1' --run bin/t.sh --out b");
  EXPECT_EQ(broken.code, 2);
  EXPECT_THAT(broken.text, HasSubstr("ended with code 1; it said last: no compiler"));
  const Said absent = matchday("compare main fast --team-repo team --run bin/other --out c");
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.text, HasSubstr("program 'bin/other' does not exist in "));

  // Mistakes leave nothing that is in the way of the right command.
  const Said odd = matchday("compare main fast --team-repo team --run bin/t.sh --out d --games 3");
  EXPECT_EQ(odd.code, 2);
  EXPECT_THAT(odd.text, HasSubstr("games = 3: must be even"));
  EXPECT_FALSE(fs::exists(folder_ / "d"));
  const Said mended = matchday(
      "compare main fast --team-repo team --build 'mkdir bin && cp t.sh bin/' --run 'bin/t.sh goals=2' "
      "--games 4 --out c --worker " +
      fakes::bin_dir() + "/coin_worker");
  EXPECT_EQ(mended.code, 0) << mended.text;
  const Said other = matchday("compare main fast --team-repo team --run bin/t.sh --games 4 --out c");
  EXPECT_EQ(other.code, 5) << "there are games of the other command";
  EXPECT_THAT(
      other.text,
      HasSubstr("c: holds games of another comparison: `build = \"mkdir bin && cp t.sh bin/\"` there, "
                "`build = \"\"` here; give another --out"));

  const std::string bin = " --build 'mkdir bin && cp t.sh bin/' --run 'bin/t.sh goals=2' --out c --worker " +
                          fakes::bin_dir() + "/coin_worker";
  const Said more = matchday("compare main fast --team-repo team --games 8" + bin);
  EXPECT_EQ(more.code, 0) << more.text;
  EXPECT_THAT(more.text, AllOf(HasSubstr("going on to 8 games from 4"), HasSubstr("4 of 8 games are there"),
                               HasSubstr("8 of 8 games")));
  EXPECT_THAT(matchday("compare main fast --team-repo team --games 8" + bin).text,
              HasSubstr("8 of 8 games are there"));
  const Said fewer = matchday("compare main fast --team-repo team --games 6" + bin);
  EXPECT_EQ(fewer.code, 5);
  EXPECT_THAT(fewer.text, HasSubstr("was begun with --games 8"));

  // A short game that fails leaves a folder without games, which is in nobody's way.
  const std::string unable = "compare main fast --team-repo team --run ./t.sh --games 4 --out e";
  EXPECT_EQ(matchday(unable).code, 3);
  EXPECT_EQ(matchday(unable + " --seed 2").code, 3);
  EXPECT_THAT(matchday("compare main main --team-repo team --games 2 --run ./t.sh --out f --worker " +
                       fakes::bin_dir() + "/coin_worker")
                  .text,
              HasSubstr("a program against itself"));
}

TEST_F(MatchdayProgram, SaysWhatTeamsSeeAndRefusesWhatCannotBe) {
  const std::string play = "play --blue " + fakes::bin_dir() + "/fake-team --yellow " + fakes::bin_dir() +
                           "/fake-team --half-length 1 ";
  EXPECT_THAT(matchday(play + "--isolation none").text, HasSubstr("isolation none, as asked for"));
  EXPECT_THAT(matchday(play).text, HasSubstr("isolation "));
  EXPECT_THAT(matchday(play + "--isolation full"),
              AllOf(testing::Field(&Said::code, 2),
                    testing::Field(&Said::text, HasSubstr("--isolation full: there is no such level"))));
  EXPECT_THAT(matchday(play + "--visible nowhere"),
              AllOf(testing::Field(&Said::code, 2),
                    testing::Field(&Said::text, HasSubstr("--visible nowhere: there is no such"))));
  // As on a machine that does not let bubblewrap work.
  std::ofstream(folder_ / "bwrap") << "#!/bin/sh\necho 'bwrap: not allowed here' >&2\nexit 1\n";
  fs::permissions(folder_ / "bwrap", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder_.string() + ":" + path).c_str(), 1);
  const Said weaker = matchday(play);
  const Said refused = matchday(play + "--isolation files");
  write_design("weak.toml", "isolation = \"network\"\n");
  const Said design = matchday("run weak.toml --no-preflight" + fake());
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(weaker.text, HasSubstr("isolation none, no more is possible here: bwrap: not allowed here"));
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.text,
              HasSubstr("--isolation files: this machine allows only 'none': bwrap: not allowed"));
  EXPECT_EQ(design.code, 2);
  EXPECT_THAT(design.text, HasSubstr("weak.toml: isolation = network: this machine allows only 'none'"));
}

TEST_F(MatchdayProgram, ARunRecordsTheIsolationAndHidesItsFolder) {
  // Team A says in its log what it finds in the result folder.
  std::ofstream(folder_ / "look.sh") << "#!/bin/sh\nls -R " << folder_.string() << "/out >&2 || true\nexec "
                                     << fakes::bin_dir() << "/fake-team --mode crash\n";
  fs::permissions(folder_ / "look.sh", fs::perms::owner_all);
  std::ofstream(folder_ / "d.toml") << "name = \"d\"\npairs = 1\n[limits]\nfaults_in_a_row = 1\n"
                                    << "[rules]\nhalf_length = 1\n[teams.a]\ncommand = \"./look.sh\"\n"
                                    << "[teams.b]\ncommand = \"" << fakes::bin_dir() << "/fake-team\"\n";
  const Said said = matchday("run d.toml --out out --no-preflight");
  EXPECT_THAT(said.text, HasSubstr("isolation "));
  std::ifstream manifest(folder_ / "out/manifest.json");
  const std::string text{std::istreambuf_iterator<char>(manifest), {}};
  EXPECT_THAT(text, HasSubstr("\"isolation\": \"isolation "));
  if (said.text.find("isolation network") == std::string::npos) GTEST_SKIP() << said.text;
  std::ifstream log(folder_ / "out/games/base-0000-0/1/blue.log");
  const std::string seen{std::istreambuf_iterator<char>(log), {}};
  EXPECT_THAT(seen, HasSubstr("games/base-0000-0/1/blue:")) << said.text;
  for (const char* hidden : {"ledger", "job.json", "manifest", "yellow"})
    EXPECT_THAT(seen, Not(HasSubstr(hidden)));
}

TEST_F(MatchdayProgram, AFolderGoesOnWithTheIsolationItBeganWithOnly) {
  write_design("none.toml", "isolation = \"none\"\n");
  write_design("files.toml", "isolation = \"files\"\n");
  const Said first = matchday("run none.toml --out r --no-preflight" + fake());
  ASSERT_EQ(first.code, 0) << first.text;
  const Said other = matchday("run files.toml --out r --no-preflight" + fake());
  if (other.code == 2) GTEST_SKIP() << other.text;  // a machine that allows no isolation
  EXPECT_EQ(other.code, 5);
  EXPECT_THAT(other.text,
              HasSubstr("were played with isolation none, now it would be files, as asked for; write "
                        "isolation = \"none\" in the design (compare: --isolation none)"));
  EXPECT_EQ(matchday("run none.toml --out r --no-preflight" + fake()).code, 0);
}

TEST_F(MatchdayProgram, PlayOfATeamThatDoesNotConnectIsAForfeitWithItsReason) {
  const Said said = matchday("play --blue true --yellow true --half-length 10");
  EXPECT_EQ(said.code, 4);
  EXPECT_THAT(said.text, HasSubstr("realism measured, rule set ssl-2015 with halves of 10 s, seed 1"));
  EXPECT_THAT(said.text, HasSubstr("not finished: "));
}

}  // namespace
