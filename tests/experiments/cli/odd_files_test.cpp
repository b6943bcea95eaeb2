// What the programs do with a path that is no regular file: one sentence at once, whatever they wanted it
// for.
#include "tests/fakes/odd_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/process/filter.h"
#include "tests/fakes/programs.h"

namespace {

namespace fs = std::filesystem;
using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;

const std::string run = "matchday run night.toml --workers 1 --worker \"$BIN\"/coin_worker";

/// A command that reads a file.
struct Reading {
  std::string file;
  std::string command;
  int code = 2;
};
void PrintTo(const Reading& reading, std::ostream* out) {
  *out << reading.command << " (" << reading.file << ")";
}

class Programs : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "odd-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    std::ofstream(folder_ / "night.toml")
        << "name = \"night\"\npairs = 1\n[teams.a]\ncommand = \"true goals=2\"\n"
        << "[teams.b]\ncommand = \"true goals=1\"\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What a command prints, and "exit N"; "hangs" when it has not ended after 30 s, of which it needs one.
  std::string said(const std::string& command) const {
    const process::Filtered done =
        process::filter({.arguments = {"/bin/sh", "-c", command + "; echo exit $?"},
                         .directory = folder_,
                         .environment = {{"BIN", fakes::bin_dir()}},
                         .patience = std::chrono::seconds{30},
                         .errors_too = true});
    return done.well ? done.output : "hangs: " + done.problem;
  }

  fs::path folder_;
};

class OddFile : public Programs, public testing::WithParamInterface<Reading> {};

TEST_P(OddFile, IsRefusedAtOnceInOneSentence) {
  const auto& [file, command, code] = GetParam();
  if (file.starts_with("results/")) {
    ASSERT_THAT(said("\"$BIN\"/" + run), EndsWith("exit 0\n"));
  }
  fs::create_directories((folder_ / file).parent_path());
  for (const fakes::OddFile& odd : fakes::odd_files()) {
    odd.make(folder_ / file);
    const std::string text = said("\"$BIN\"/" + command);
    // A run refuses links and all that is neither file nor folder in its folder, before it reads them.
    const bool of_a_run = command == run && file.starts_with("results/");
    const std::string by_run = of_a_run ? ", and a run writes into its own folder only" : odd.sentence;
    EXPECT_THAT(text, AnyOf(HasSubstr(file + ": " + odd.sentence), HasSubstr(by_run))) << odd.name;
    EXPECT_THAT(text, HasSubstr(file + ": is ")) << odd.name;
    EXPECT_THAT(text, EndsWith("\nexit " + std::to_string(code) + "\n")) << odd.name;
  }
}

const std::string teams = " --half-length 1 --blue team-chaser --yellow team-chaser";

INSTANTIATE_TEST_SUITE_P(OfACommandLine, OddFile,
                         testing::Values(Reading{"odd.toml", "matchday run odd.toml"},
                                         Reading{"odd.toml", "matchday plan odd.toml"},
                                         Reading{"odd.toml", "matchday judge odd.toml"},
                                         Reading{"odd.toml", "matchday realism odd.toml"},
                                         Reading{"odd.toml", "matchday play --realism odd.toml" + teams},
                                         Reading{"odd.replies", "matchday continue odd.replies"},
                                         Reading{"odd.replies.gz", "matchday continue odd.replies.gz"},
                                         Reading{"odd.json", "matchday bench --compare odd.json"},
                                         Reading{"odd.log", "ssl-autoref replay odd.log"},
                                         Reading{"odd.log.gz", "ssl-autoref replay odd.log.gz"},
                                         Reading{"odd.log", "ssl-autoref calibrate odd.log"},
                                         Reading{"odd.log.gz", "ssl-autoref calibrate odd.log.gz"},
                                         Reading{"odd.toml", "team-reference --config odd.toml"}));

// Trouble with a result folder has an exit code of its own.
INSTANTIATE_TEST_SUITE_P(
    OfAResultFolder, OddFile,
    testing::Values(Reading{"results/night/ledger.sqlite", "matchday report results/night", 5},
                    Reading{"results/night/ledger.sqlite", "matchday verify results/night", 5},
                    Reading{"results/night/ledger.sqlite", run, 5},
                    Reading{"results/night/ledger.sqlite", "matchday plan night.toml --from results/night",
                            5},
                    Reading{"results/night/ledger.sqlite-wal", "matchday report results/night", 5},
                    Reading{"results/night/ledger.sqlite-journal", "matchday report results/night", 5},
                    Reading{"results/night/ledger.sqlite-shm", run, 5},
                    Reading{"results/night/manifest.json", "matchday verify results/night", 5},
                    Reading{"results/night/manifest.json", "matchday report results/night --html", 5}));

class OddFileOfARun : public OddFile {};

// What a run only writes, or can do without.
TEST_P(OddFileOfARun, IsRefusedToo) {
  ASSERT_THAT(said("\"$BIN\"/" + run), EndsWith("exit 0\n"));
  fakes::make_pipe(folder_ / GetParam().file);
  const std::string text = said("\"$BIN\"/" + run);
  EXPECT_THAT(text, HasSubstr(GetParam().file + ": is neither file nor folder"));
  EXPECT_THAT(text, EndsWith("exit 5\n"));
}

INSTANTIATE_TEST_SUITE_P(Files, OddFileOfARun,
                         testing::Values(Reading{"results/night/scratch", ""},
                                         Reading{"results/night/status.json", ""},
                                         Reading{"results/night/status.json.part", ""}));

class OddOutput : public Programs {};

TEST_F(OddOutput, IsAPipeThatNobodyReads) {
  for (const std::string flag : {"--log odd.log", "--log odd.log.gz", "--record odd.replies"}) {
    const std::string file = flag.substr(flag.find(' ') + 1);
    fakes::make_pipe(folder_ / file);
    EXPECT_THAT(said("\"$BIN\"/matchday play" + teams + " " + flag),
                EndsWith("matchday: " + file +
                         ": cannot be created: nobody reads this named pipe (FIFO) or socket\nexit 74\n"));
  }
}

TEST_F(OddOutput, IsADeviceThatTakesEverything) {
  fs::create_symlink("/dev/null", folder_ / "odd.log");
  EXPECT_THAT(said("\"$BIN\"/matchday play" + teams + " --log odd.log"), EndsWith("exit 0\n"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

// 512 bytes or 1 KiB stand for a disk that is full.
TEST_F(OddOutput, OnAFullDiskIsAnOutputErrorAndLeavesNothing) {
  for (const std::string flag : {"--log game.log", "--log game.log.gz", "--record game.replies"}) {
    const std::string file = flag.substr(flag.find(' ') + 1);
    EXPECT_THAT(said("ulimit -f 1; trap '' XFSZ; \"$BIN\"/matchday play" + teams + " " + flag),
                EndsWith("matchday: " + file + ": cannot be written: File too large\nexit 74\n"));
    EXPECT_FALSE(fs::exists(folder_ / file));
    fs::create_symlink("/dev/full", folder_ / file);
    EXPECT_THAT(said("\"$BIN\"/matchday play" + teams + " " + flag),
                EndsWith("matchday: " + file + ": cannot be written: No space left on device\nexit 74\n"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    EXPECT_TRUE(fs::is_symlink(folder_ / file)) << "what was there is not ours to remove";
  }
}

}  // namespace
