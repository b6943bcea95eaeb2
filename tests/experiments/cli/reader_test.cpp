// A result folder that somebody else made: reading it starts nothing that was not allowed, and tells what does
// not fit together although all checksums are right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "experiments/record/ledger.h"
#include "tests/experiments/cli/matchday_program.h"
#include "tests/fakes/odd_files.h"
#include "tests/fakes/programs.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class FolderOfOthers : public MatchdayProgram {
 protected:
  /// A folder of two games whose teams are this command, played by a fake worker.
  void make_folder(const std::string& team, const std::string& more = "") const {
    std::ofstream(folder_ / "d.toml") << "name = \"d\"\npairs = 1\n"
                                      << more << "[teams.a]\n"
                                      << team << "[teams.b]\n"
                                      << team;
    const Said said = matchday("run d.toml --out r --no-preflight" + fake());
    ASSERT_EQ(said.code, 0) << said.text;
  }
  /// A command that leaves a file behind where it is started without isolation.
  std::string touch(const std::string& key = "command") const {
    return key + " = [\"/bin/sh\", \"-c\", \"touch " + mark().string() + "\"]\n";
  }
  fs::path mark() const { return folder_ / "mark"; }
  fs::path ledger() const { return folder_ / "r/ledger.sqlite"; }
  std::string text_of(const fs::path& file) const {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
};

TEST_F(FolderOfOthers, StartsItsProgramsOnlyIsolatedOrWhenThatIsAllowed) {
  make_folder(touch(), "isolation = \"none\"\n");
  for (const std::string command : {"verify r", "replay r base-0000-0"}) {
    const Said said = matchday(command);
    EXPECT_NE(said.code, 0) << said.text;
    EXPECT_FALSE(fs::exists(mark())) << said.text;
    EXPECT_THAT(matchday(command.substr(0, 6) + " --help").text,
                HasSubstr("STARTS THE PROGRAMS THAT THE FOLDER NAMES"));
    EXPECT_EQ(matchday(command + " --isolation some").code, 2);
    matchday(command + " --isolation none");
    EXPECT_TRUE(fs::remove(mark())) << command << " was allowed to";
  }
}

TEST_F(FolderOfOthers, BuildsNothingUnlessThatIsAllowed) {
  shell(
      "mkdir repo && cd repo && git init -q && git -c user.name=a -c user.email=b commit -q --allow-empty -m "
      "1");
  make_folder("repository = \"" + (folder_ / "repo").string() + "\"\nrevision = \"HEAD\"\nbuild = \"touch " +
              mark().string() + "\"\nrun = \"/bin/sh -c true\"\n");
  ASSERT_TRUE(fs::remove(mark()));
  fs::remove_all(folder_ / "r/builds");
  const Said verified = matchday("verify r");
  EXPECT_EQ(verified.code, 4) << verified.text;
  EXPECT_THAT(verified.text, HasSubstr("--build allows that"));
  const Said replayed = matchday("replay r base-0000-0");
  EXPECT_EQ(replayed.code, 2);
  EXPECT_THAT(replayed.text, HasSubstr("--build allows that"));
  EXPECT_FALSE(fs::exists(mark()));
  EXPECT_FALSE(fs::exists(folder_ / "r/builds"));
  matchday("replay r base-0000-0 --build");
  EXPECT_TRUE(fs::exists(mark()));
}

TEST_F(FolderOfOthers, TellsThatTheDesignIsNotThatOfTheGames) {
  make_folder("command = \"true\"\n");
  EXPECT_EQ(matchday("verify r --sample 0").code, 0);
  const record::Experiment right = record::Ledger::read(ledger()).experiment();
  record::Ledger::grow(ledger(), right.hash, {right.hash, "seed = 4\n" + right.design});
  const Said said = matchday("verify r --sample 0");
  EXPECT_EQ(said.code, 5) << said.text;
  EXPECT_THAT(said.text, AllOf(HasSubstr("manifest      the ledger's design makes experiment "),
                               HasSubstr(", not " + right.hash), HasSubstr("NOT as written")));
  // What decides no game may be different.
  record::Ledger::grow(ledger(), right.hash, {right.hash, "# a note\n" + right.design});
  EXPECT_EQ(matchday("verify r --sample 0").code, 0);
}

TEST_F(FolderOfOthers, TellsGamesThatTheDesignDoesNotHave) {
  make_folder("command = \"true\"\n");
  {
    const record::Experiment experiment = record::Ledger::read(ledger()).experiment();
    record::Ledger changed = record::Ledger::open(ledger(), experiment);
    record::Attempt attempt = changed.attempts().front();
    attempt.attempt = 2;
    attempt.seed += 1;
    changed.add(attempt);
    attempt.key.pair = 7;
    changed.add(attempt);
    changed.put_together();
  }
  const Said said = matchday("verify r --sample 0");
  EXPECT_EQ(said.code, 5) << said.text;
  EXPECT_THAT(said.text,
              AllOf(HasSubstr("attempts      2 as written, DAMAGED 2\n"),
                    HasSubstr("game base-0000-0, attempt 2 has another seed"),
                    HasSubstr("game base-0007-0, attempt 2 is a game that the design does not have")));
}

TEST_F(FolderOfOthers, IsReadToItsEndWhateverItsManifestNames) {
  make_folder("command = \"true\"\n");
  const fs::path manifest = folder_ / "r/manifest.json";
  const std::string right = text_of(manifest);
  std::string wrong = right;
  const std::string worker = fakes::bin_dir() + "/fake_worker";
  wrong.replace(wrong.find("{\"path\": \"" + worker) + 10, worker.size(), "/dev/zero");
  std::ofstream(manifest) << wrong;
  Said said = shell("timeout 20 \"$BIN\"/matchday verify r");
  EXPECT_EQ(said.code, 5);
  EXPECT_THAT(said.text, HasSubstr("/dev/zero: changed"));
  std::ofstream(manifest) << right;
  EXPECT_EQ(matchday("verify r --sample 0").code, 0);
  for (const fakes::OddFile& odd : fakes::odd_files()) {
    odd.make(manifest);
    said = shell("timeout 20 \"$BIN\"/matchday verify r");
    EXPECT_EQ(said.code, 5);
    EXPECT_THAT(said.text, HasSubstr("manifest.json: " + odd.sentence));
  }
}

}  // namespace
