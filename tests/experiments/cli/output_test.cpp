// What the programs do when their output cannot be written, or what they print comes from somebody else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "experiments/process/filter.h"
#include "tests/fakes/programs.h"

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Output : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "output-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// A line for the shell in our folder, where $BIN is the folder of the programs; returns what it prints.
  std::string shell(const std::string& line, const std::string& temporary = "") const {
    process::Filter filter{.arguments = {"/bin/sh", "-c", line}, .directory = folder_, .errors_too = true};
    filter.environment = {{"BIN", fakes::bin_dir()}};
    if (!temporary.empty()) filter.environment.emplace_back("TMPDIR", temporary);
    return process::filter(filter).output;
  }

  /// What a command says on standard error and ends with, standard output going to `place`.
  std::string said(const std::string& command, const std::string& place = "/dev/full") const {
    return shell("\"$BIN\"/" + command + " > " + place +
                 " 2> errors; code=$?; tail -n 1 errors; echo exit $code");
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string read(const fs::path& file) const {
    std::ifstream stream(folder_ / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void write_design(const std::string& more = "") const {
    write("night.toml", "name = \"night\"\npairs = 2\n[teams.a]\ncommand = \"true goals=2\"\n" + more +
                            "[teams.b]\ncommand = \"true goals=1\"\n");
  }
  std::string run() const { return "matchday run night.toml --worker \"$BIN\"/coin_worker"; }

  const std::string full_ = ": cannot write standard output: No space left on device\nexit 74\n";
  fs::path folder_;
};

TEST_F(Output, ThatIsNotTakenIsAnErrorOfEveryCommandThatNeedsNoGame) {
  write_design();
  shell("\"$BIN\"/" + run());
  for (const std::string command :
       {"--help", "--version", "run --help", "realism", "report results/night",
        "report results/night --format markdown", "report results/night --format csv",
        "report results/night --format json", "report results/night --format latex",
        "report results/night --html", "plan night.toml --workers 1"}) {
    EXPECT_EQ(said("matchday " + command), "matchday" + full_) << command;
  }
  for (const std::string command : {"--help", "automaton", "positions"}) {
    EXPECT_EQ(said("ssl-autoref " + command), "ssl-autoref" + full_) << command;
  }
  for (const std::string command : {"--help", "--version"})
    EXPECT_EQ(said("ssl-sim " + command), "ssl-sim" + full_);
  EXPECT_EQ(said("matchday report results/night", "table"), "exit 0\n");
}

TEST_F(Output, ThatIsNotTakenIsAnErrorOfEveryCommandThatPlays) {
  const std::string team = "\"$BIN/fake-team --mode wander\"";
  const std::string play = "matchday play --half-length 1 --blue " + team + " --yellow " + team;
  ASSERT_THAT(said(play + " --log game.log.gz --record game.replies", "told"), EndsWith("exit 0\n"));
  EXPECT_EQ(said(play), "matchday" + full_);
  EXPECT_EQ(said(play + " --json"), "matchday" + full_);
  EXPECT_EQ(said("matchday continue game.replies"), "matchday" + full_);
  EXPECT_EQ(said("matchday bench --half-length 1 --workers 0"), "matchday" + full_);
  for (const std::string how : {"", " --json", " --mode watch"})
    EXPECT_EQ(said("ssl-autoref replay game.log.gz" + how), "ssl-autoref" + full_);
  const std::string command = "command = [\"" + fakes::bin_dir() + "/fake-team\", \"--mode\", \"wander\"]\n";
  write("real.toml", "name = \"real\"\npairs = 1\n[rules]\nhalf_length = 1\n[teams.a]\n" + command +
                         "[teams.b]\n" + command);
  EXPECT_EQ(said("matchday judge real.toml"), "matchday" + full_);
  EXPECT_EQ(said("matchday judge real.toml --show base-0000-0:10-20"), "matchday" + full_);
}

// A night plays on without its terminal; the table that could not be printed is told by the code.
TEST_F(Output, OfARunIsDroppedAndTheGamesArePlayed) {
  write_design();
  EXPECT_EQ(shell("\"$BIN\"/" + run() + " > /dev/full 2> /dev/full; echo exit $?"), "exit 74\n");
  EXPECT_THAT(shell("\"$BIN\"/matchday report results/night"), HasSubstr("4 of 4 games"));
  fs::remove_all(folder_ / "results");
  EXPECT_EQ(shell("\"$BIN\"/" + run() + " > table 2> /dev/full; echo exit $?"), "exit 0\n");
  EXPECT_THAT(read("table"), HasSubstr("4 of 4 games"));
  fs::remove_all(folder_ / "results");
  shell("\"$BIN\"/" + run() + " 2>&1 | true");
  EXPECT_THAT(shell("\"$BIN\"/matchday report results/night"), HasSubstr("4 of 4 games"));
  fs::remove_all(folder_ / "results");
  shell("\"$BIN\"/" + run() + " <&- >&- 2>&-");
  EXPECT_THAT(shell("\"$BIN\"/matchday report results/night"), HasSubstr("4 of 4 games"))
      << "nothing was printed into the ledger";
}

TEST_F(Output, WhoseReaderHasGoneEndsQuietly) {
  for (const std::string command : {"matchday --help", "ssl-autoref automaton", "ssl-sim --help"}) {
    shell("(sleep 0.2; \"$BIN\"/" + command + " 2> errors; echo $? > code) | true");
    EXPECT_EQ(read("code"), "141\n") << command;
    EXPECT_EQ(read("errors"), "");
  }
}

TEST_F(Output, ToFilesIsWholeOrNotThere) {
  write_design();
  shell("\"$BIN\"/" + run());
  const std::string before = read("results/night/report.html");
  ASSERT_THAT(before, HasSubstr("</html>"));
  const std::string limit = "ulimit -f 1; trap '' XFSZ; ";  // 512 bytes or 1 KiB
  EXPECT_THAT(shell(limit + "\"$BIN\"/matchday report results/night --html; echo exit $?"),
              AllOf(HasSubstr("report.html: cannot be written: File too large"), EndsWith("exit 5\n")));
  EXPECT_EQ(read("results/night/report.html"), before);
  EXPECT_THAT(shell("ls results/night"), Not(HasSubstr(".part")));
  if (shell("command -v gnuplot").empty()) return;
  fs::create_directories(folder_ / "drawn/conditions-goals.svg");
  EXPECT_THAT(
      shell("\"$BIN\"/matchday report results/night --figures drawn; echo exit $?"),
      AllOf(HasSubstr("conditions-goals.svg: cannot be written: Is a directory"), EndsWith("exit 5\n")));
  EXPECT_EQ(shell("ls drawn"), "conditions-goals.svg\n");
}

// The names of somebody else's result folder, as they stand in its ledger.
TEST_F(Output, NamesRunNothing) {
  write_design("name = '`touch marker` $(touch marker) \"; system \"touch marker\" @PWD <b>'\n");
  shell("\"$BIN\"/" + run());
  shell(
      "\"$BIN\"/matchday report results/night --html; \"$BIN\"/matchday report results/night --figures "
      "drawn");
  EXPECT_EQ(shell("find . -name marker"), "");
  const std::string page = read("results/night/report.html");
  EXPECT_THAT(
      page,
      HasSubstr("`touch marker` $(touch marker) &quot;; system &quot;touch marker&quot; @PWD &lt;b&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<b>,")));
  if (shell("command -v gnuplot").empty()) return;
  EXPECT_THAT(read("drawn/conditions-goals.svg"), HasSubstr("<text>A `touch marker` $(touch ma...</text>"));
}

TEST_F(Output, NamesDoNotActOnTheTerminal) {
  const std::string text = shell("\"$BIN\"/matchday \"$(printf 'dance\\033[2J\\nmore')\"");
  EXPECT_EQ(text.find('\x1B'), std::string::npos);
  EXPECT_THAT(text, StartsWith("matchday: unknown command 'dance\xEF\xBF\xBD[2J more'; known are"));
}

TEST_F(Output, AFolderForTemporaryFilesThatDoesNotFitIsRefusedAtOnce) {
  write_design();
  const fs::path deep = folder_ / std::string(100, 'x');
  fs::create_directory(deep);
  for (const std::string& command :
       std::vector<std::string>{"matchday play --blue true --yellow true", run(), "matchday plan night.toml",
                                "matchday bench", "matchday judge night.toml"}) {
    EXPECT_THAT(shell("\"$BIN\"/" + command + "; echo exit $?", deep),
                AllOf(StartsWith("matchday: TMPDIR " + deep.string().substr(0, 100)),
                      HasSubstr("whose paths have at most 107; give it a shorter value\nexit 2\n")))
        << command;
    EXPECT_THAT(shell("\"$BIN\"/" + command + "; echo exit $?", "/nowhere/at all"),
                HasSubstr("TMPDIR /nowhere/at all: is no folder in which files can be made; give it another "
                          "value\nexit 2\n"));
  }
  EXPECT_FALSE(fs::exists(folder_ / "results"));
}

TEST_F(Output, AnyOtherFolderForTemporaryFilesWorks) {
  write_design();
  const fs::path odd = folder_ / "a 'b' `c` \"";
  fs::create_directory(odd);
  EXPECT_THAT(shell("\"$BIN\"/" + run() + "; echo exit $?", odd), EndsWith("exit 0\n"));
  EXPECT_THAT(shell("\"$BIN\"/matchday report results/night --html; echo exit $?", odd),
              EndsWith("exit 0\n"));
  EXPECT_TRUE(fs::is_empty(odd));
  EXPECT_EQ(shell("find . -name c"), "");
}

}  // namespace
