// `matchday verify` as its user has it.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/experiments/cli/matchday_program.h"
#include "tests/fakes/programs.h"

namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST_F(MatchdayProgram, VerifySaysWhetherAFolderIsWhatWasWritten) {
  write_design("good.toml");
  ASSERT_EQ(matchday("run good.toml --out r --no-preflight" + fake()).code, 0);
  const Said good = matchday("verify r --sample 0");
  EXPECT_EQ(good.code, 0) << good.text;
  EXPECT_THAT(
      good.text,
      AllOf(HasSubstr("attempts      8 as written\n"), HasSubstr("fake_worker: same"),
            HasSubstr("rows, files and manifest are as written; no game was played again, as asked")));
  std::ofstream(folder_ / "r/manifest.json", std::ios::app) << "x";
  const Said bad = matchday("verify r --sample 0");
  EXPECT_EQ(bad.code, 5);
  EXPECT_THAT(bad.text, AllOf(HasSubstr("manifest.json has"), HasSubstr("NOT as written: 2 findings")));
  EXPECT_EQ(matchday("verify nowhere").code, 5);
}

TEST_F(MatchdayProgram, VerifyIsNoSuccessWhenNoGameCouldBeComparedWithItsHash) {
  write_design("good.toml");
  std::ofstream(folder_ / "worker.sh") << "#!/bin/sh\nexec " << fakes::bin_dir() << "/fake_worker \"$@\"\n";
  fs::permissions(folder_ / "worker.sh", fs::perms::owner_all);
  ASSERT_EQ(matchday("run good.toml --out r --no-preflight --worker ./worker.sh").code, 0);
  std::ofstream(folder_ / "worker.sh", std::ios::app) << "# changed\n";
  const Said said = matchday("verify r");
  EXPECT_EQ(said.code, 4) << said.text;
  EXPECT_THAT(said.text,
              HasSubstr("verdict       what could be verified is as written; NOT VERIFIED: 0 of 3 sampled "
                        "games could be compared: its replies were not kept, and programs are not those "
                        "that played (worker.sh changed)"));
  const auto json = nlohmann::json::parse(matchday("verify r --json").text);
  EXPECT_EQ(json.at("exit_code"), 4);
  EXPECT_EQ(json.at("rows").at("attempts").at("as_written"), 8);
  EXPECT_EQ(json.at("games").at("sampled"), 3);
  EXPECT_EQ(json.at("games").at("unverified"), 3);
  EXPECT_EQ(json.at("unverified").size(), 1U);
}

TEST_F(MatchdayProgram, VerifyGoesOnAfterDamagedRows) {
  write_design("good.toml");
  ASSERT_EQ(matchday("run good.toml --out r --no-preflight" + fake()).code, 0);
  SQLite::Database((folder_ / "r/ledger.sqlite").string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE attempts SET goals_blue = goals_blue + 1 WHERE pair = 0");
  fs::remove(folder_ / "r/manifest.json");
  const Said said = matchday("verify r --sample 0");
  EXPECT_EQ(said.code, 5);
  EXPECT_THAT(said.text,
              AllOf(HasSubstr("attempts      4 as written, DAMAGED 4\n"),
                    HasSubstr("game one-0000-0, attempt 1 is damaged"), HasSubstr("manifest.json is missing"),
                    HasSubstr("there is none; nobody can say"),
                    HasSubstr("NOT as written: 5 findings, see above; not verified: ")));
}

TEST_F(MatchdayProgram, WritesNoGameIntoAResultFolderNorOverAnotherKindOfFile) {
  write_design("good.toml");
  ASSERT_EQ(matchday("run good.toml --out F --workers 2" + fake()).code, 0);
  std::filesystem::create_symlink("F/ledger.sqlite", folder_ / "link.log");
  std::filesystem::create_directory_symlink("F", folder_ / "linked");
  std::ofstream(folder_ / "notes.txt") << "mine\n";
  std::filesystem::create_symlink("notes.txt", folder_ / "notes.log");
  const std::string before = matchday("verify F --sample 0").text;
  const std::string play = "play --blue true --yellow true ";
  const std::string replay = "replay F one-0000-0 ";
  for (const std::string& command : {play, replay}) {
    for (const auto& [options, message] : std::vector<std::pair<std::string, std::string>>{
             {"--log F/ledger.sqlite", "--log F/ledger.sqlite: must end in .log or .log.gz"},
             {"--log link.log", "--log link.log: is a link to "},
             {"--log notes.log", "notes.txt, which must end in .log or .log.gz"},
             {"--log nowhere/x.log", "there is no folder nowhere; make it first"},
             {"--log F/x.log", "F, where only its run writes; give another place"},
             {"--log linked/x.log", "F, where only its run writes; give another place"},
             {"--team-logs F/games/x", "F, where only its run writes; give another place"}}) {
      const Said said = matchday(command + options);
      EXPECT_EQ(said.code, 2) << command << options;
      EXPECT_THAT(said.text, HasSubstr(message)) << command << options;
    }
  }
  EXPECT_THAT(matchday(play + "--record F/x.replies").text, HasSubstr("where only its run writes"));
  EXPECT_EQ(matchday("verify F --sample 0").text, before);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "F/games/x"));
}

}  // namespace
