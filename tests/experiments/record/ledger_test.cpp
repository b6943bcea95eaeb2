#include "experiments/record/ledger.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "tests/experiments/record/examples.h"

namespace record {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class LedgerTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "ledger-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "ledger.sqlite"; }
  Ledger open() const { return Ledger::open(file(), experiment_); }

  void exec(const std::string& sql) const {
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE).exec(sql);
  }

  /// The file as schema 2 wrote it: without checksums.
  void make_old(int version) const {
    exec("ALTER TABLE attempts DROP COLUMN checksum");
    exec("ALTER TABLE audits DROP COLUMN checksum");
    exec("DROP TABLE files");
    exec("DELETE FROM experiment WHERE key NOT IN ('hash', 'design')");
    exec("PRAGMA journal_mode = DELETE");
    exec("PRAGMA user_version = " + std::to_string(version));
  }

  template <class Action>
  static std::string complaint(Action action) {
    try {
      action();
    } catch (const StorageError& error) {
      return error.what();
    }
    return "nothing thrown";
  }

  fs::path folder_;
  Experiment experiment_{"00112233445566778899aabbccddeeff", "name = \"test\"\n"};
};

TEST_F(LedgerTest, GivesBackWhatWasWrittenAlsoAfterReopening) {
  {
    Ledger ledger = open();
    ledger.add(example_attempt(1, 0));
    ledger.add(void_attempt(0, 1, 1));
    ledger.add(example_attempt(0, 1, 2));
  }
  open().add(example_attempt(0, 0));
  EXPECT_THAT(Ledger::read(file()).attempts(), ElementsAre(example_attempt(0, 0), void_attempt(0, 1, 1),
                                                           example_attempt(0, 1, 2), example_attempt(1, 0)));
  EXPECT_EQ(Ledger::read(file()).experiment(), experiment_);
}

// Nine tenths of a full game's record: whoever reads a thousand games for a table must not hold them.
TEST_F(LedgerTest, LeavesTheTimelinesOutWhenTold) {
  open().add(example_attempt(0, 0));
  Attempt expected = example_attempt(0, 0);
  ASSERT_FALSE(expected.record.timeline.empty());
  expected.record.timeline.clear();
  EXPECT_THAT(Ledger::read(file()).attempts(Detail::WithoutTimeline), ElementsAre(expected));
}

TEST_F(LedgerTest, NamesTheGameWhoseRecordIsDamagedHoweverItIsRead) {
  open().add(example_attempt(0, 0));
  exec("UPDATE attempts SET record = '{\"goals\"'");
  for (const Detail detail : {Detail::Whole, Detail::WithoutTimeline}) {
    EXPECT_THAT(complaint([&] { Ledger::read(file()).attempts(detail); }),
                HasSubstr("game equal-0000-0, attempt 1 is damaged: its contents are not those"));
  }
  make_old(2);
  for (const Detail detail : {Detail::Whole, Detail::WithoutTimeline}) {
    EXPECT_THAT(complaint([&] { Ledger::read(file()).attempts(detail); }),
                HasSubstr("game equal-0000-0, attempt 1 cannot be read"));
  }
}

TEST_F(LedgerTest, KeepsAuditsTheLastOfEachAttempt) {
  const Audit same{{"equal", 3, 1}, 1, Verdict::Same, "abc", ""};
  Audit other{{"equal", 2, 0}, 2, Verdict::Failed, "", "the worker died"};
  {
    Ledger ledger = open();
    EXPECT_TRUE(ledger.audits().empty());
    ledger.add(same);
    ledger.add(other);
    other.verdict = Verdict::TeamDiffers;
    other.hash = "def";
    other.reason.clear();
    ledger.add(other);
  }
  EXPECT_THAT(Ledger::read(file()).audits(), ElementsAre(other, same));
}

TEST_F(LedgerTest, OneWithoutAuditsIsReadAndGetsThem) {
  open();
  make_old(2);
  exec("DROP TABLE audits");
  EXPECT_TRUE(Ledger::read(file()).audits().empty());
  open().add(Audit{{"equal", 0, 0}, 1, Verdict::Same, "abc", ""});
  EXPECT_EQ(Ledger::read(file()).audits().size(), 1U);
}

TEST_F(LedgerTest, SaysWhichAuditIsDamaged) {
  open().add(Audit{{"equal", 0, 1}, 1, Verdict::Same, "abc", ""});
  exec("UPDATE audits SET verdict = 'fine'");
  EXPECT_THAT(complaint([&] { Ledger::read(file()).audits(); }),
              HasSubstr("audit of game equal-0000-1, attempt 1 is damaged"));
  make_old(2);
  EXPECT_THAT(complaint([&] { Ledger::read(file()).audits(); }),
              HasSubstr("audit of game equal-0000-1, attempt 1 cannot be read: unknown verdict 'fine'; "
                        "known are: same"));
}

TEST_F(LedgerTest, TakesEveryAttemptOnlyOnce) {
  Ledger ledger = open();
  ledger.add(example_attempt(0, 0));
  EXPECT_THAT(complaint([&] { ledger.add(example_attempt(0, 0)); }), HasSubstr("ledger.sqlite"));
  EXPECT_EQ(ledger.attempts().size(), 1U);
}

TEST_F(LedgerTest, CanBeReadWhileItIsOpenForWriting) {
  Ledger ledger = open();
  ledger.add(example_attempt(0, 0));
  EXPECT_EQ(Ledger::read(file()).attempts().size(), 1U);
}

TEST_F(LedgerTest, RefusesAnotherExperimentNamingBothHashes) {
  open();
  const Experiment other{"ffffffffffffffffffffffffffffffff", ""};
  const std::string message = complaint([&] { Ledger::open(file(), other); });
  EXPECT_THAT(message, HasSubstr(experiment_.hash));
  EXPECT_THAT(message, HasSubstr(other.hash));
}

TEST_F(LedgerTest, RefusesANewerSchemaNamingBothNumbers) {
  open();
  SQLite::Database(file().string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version = 7");
  for (const std::string& message : {complaint([&] { open(); }), complaint([&] { Ledger::read(file()); })}) {
    EXPECT_THAT(message, HasSubstr("schema 7"));
    EXPECT_THAT(message, HasSubstr("only up to 4"));
  }
}

TEST_F(LedgerTest, ShowsTheStatisticsAsColumnsOfTheViewGames) {
  open().add(example_attempt(0, 0));
  SQLite::Database database(file().string());
  SQLite::Statement row(
      database, "SELECT game, shots_blue, possession_yellow, longest_passage, goals_yellow FROM games");
  ASSERT_TRUE(row.executeStep());
  EXPECT_EQ(row.getColumn(0).getString(), "equal-0000-0");
  EXPECT_EQ(row.getColumn(1).getInt(), 8);
  EXPECT_DOUBLE_EQ(row.getColumn(2).getDouble(), 300.5);
  EXPECT_DOUBLE_EQ(row.getColumn(3).getDouble(), 44.5);
  EXPECT_EQ(row.getColumn(4).getInt(), 2);
}

// As version 1 wrote it: no view, and records without statistics and kinds of fouls.
TEST_F(LedgerTest, ReadsSchema1AndBringsItUpToDateWhenWriting) {
  Attempt old = example_attempt(0, 0);
  open().add(old);
  make_old(2);
  exec("UPDATE attempts SET record = json_remove(record, '$.statistics', '$.fouls_by_kind')");
  exec("DROP VIEW games");
  exec("PRAGMA user_version = 1");
  old.record.statistics.reset();
  old.record.fouls_by_kind = {};
  EXPECT_THAT(Ledger::read(file()).attempts(), ElementsAre(old));
  open().add(example_attempt(0, 1));
  EXPECT_THAT(Ledger::read(file()).attempts(), ElementsAre(old, example_attempt(0, 1)));
  SQLite::Database database(file().string());
  EXPECT_EQ(database.execAndGet("SELECT count(shots_blue) FROM games").getInt(), 1);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), Ledger::schema);
}

TEST_F(LedgerTest, RefusesWhatIsNoLedger) {
  SQLite::Database(file().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE x (y)");
  EXPECT_THAT(complaint([&] { open(); }), HasSubstr("not a ledger"));
  std::ofstream(folder_ / "text") << "this is not a database, but it is long enough to have a header\n";
  EXPECT_THAT(complaint([&] { Ledger::read(folder_ / "text"); }), HasSubstr("damaged"));
  EXPECT_THAT(complaint([&] { Ledger::read(folder_ / "nothing"); }), HasSubstr("there is no ledger"));
}

TEST_F(LedgerTest, RefusesADamagedFile) {
  {
    Ledger ledger = open();
    for (int pair = 0; pair < 50; ++pair) ledger.add(example_attempt(pair, 0));
  }
  {
    std::fstream stream(file(), std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(8192);
    stream << std::string(16'384, '\x5a');
  }
  EXPECT_THAT(complaint([&] { Ledger::read(file()).attempts(); }), HasSubstr("damaged"));
  EXPECT_THAT(complaint([&] { open(); }), HasSubstr("damaged"));
}

TEST_F(LedgerTest, BeginsAnewWhenTheFirstStartWasCutShort) {
  std::ofstream(file()).close();  // what is left when the run was killed before the first commit
  EXPECT_THAT(complaint([&] { Ledger::read(file()); }), HasSubstr("still empty"));
  open().add(example_attempt(0, 0));
  EXPECT_EQ(open().attempts().size(), 1U);
}

}  // namespace
}  // namespace record
