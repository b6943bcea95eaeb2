// A ledger's rows are what was written, or it is noticed.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <xxhash.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <random>

#include "experiments/record/checksum.h"
#include "experiments/record/ledger.h"
#include "tests/experiments/record/examples.h"

namespace record {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class LedgerTrust : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "ledger-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    Ledger ledger = open();
    for (int pair = 0; pair < 3; ++pair) ledger.add(example_attempt(pair, 0));
    ledger.add(void_attempt(1, 1, 1), std::vector<KeptFile>{{"games/equal-0001-1/1/worker.log", 5, "abc"}});
    ledger.add(Audit{{"equal", 1, 0}, 1, Verdict::Same, "abc", ""});
    ledger.put_together();
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "ledger.sqlite"; }
  Ledger open() const { return Ledger::open(file(), experiment_); }
  void exec(const std::string& sql) const {
    SQLite::Database(file().string(), SQLite::OPEN_READWRITE).exec(sql);
  }
  std::string complaint() const {
    try {
      const Ledger ledger = Ledger::read(file());
      ledger.attempts();
      ledger.audits();
      ledger.files();
    } catch (const StorageError& error) {
      return error.what();
    }
    return "nothing thrown";
  }
  static std::size_t damaged(const LedgerCheck& check) {
    return check.attempts.damaged.size() + check.audits.damaged.size() + check.files.damaged.size() +
           check.experiment.damaged.size();
  }

  fs::path folder_;
  Experiment experiment_{"00112233445566778899aabbccddeeff", "name = \"test\"\n"};
};

TEST_F(LedgerTrust, FindsNothingWrongWithWhatItWrote) {
  const LedgerCheck check = Ledger::read(file()).check();
  EXPECT_EQ(check.attempts.whole, 4);
  EXPECT_EQ(check.audits.whole, 1);
  EXPECT_EQ(check.files.whole, 1);
  EXPECT_EQ(check.experiment.whole, 1);
  EXPECT_EQ(damaged(check), 0U);
  EXPECT_EQ(complaint(), "nothing thrown");
}

// As record/README.md says it, with SQLite's own functions instead of ours.
TEST_F(LedgerTrust, ItsChecksumsCanBeComputedBySomebodyElse) {
  SQLite::Database database(file().string());
  for (const std::string table : {"attempts", "audits", "files"}) {
    std::string text = "'" + std::to_string(table.size()) + ":" + table + "'";
    SQLite::Statement columns(database, "SELECT name, type FROM pragma_table_info('" + table + "')");
    while (columns.executeStep()) {
      const std::string name = columns.getColumn(0).getString();
      if (name == "checksum") continue;
      const std::string value =
          columns.getColumn(1).getString() == "REAL" ? "printf('%!.17g', " + name + ")" : name;
      text += " || length(CAST(" + value + " AS BLOB)) || ':' || " + value;
    }
    SQLite::Statement rows(database, "SELECT " + text + ", checksum FROM " + table);
    int count = 0;
    for (; rows.executeStep(); ++count) {
      const std::string bytes = rows.getColumn(0).getString();
      const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
      std::array<char, 33> digits{};
      std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                    static_cast<unsigned long long>(hash.high64),
                    static_cast<unsigned long long>(hash.low64));
      EXPECT_EQ(rows.getColumn(1).getString(), digits.data()) << bytes;
    }
    EXPECT_GT(count, 0);
  }
}

struct Change {
  const char* sql;
  const char* sentence;
};
class LedgerChange : public LedgerTrust, public testing::WithParamInterface<Change> {};

TEST_P(LedgerChange, IsNoticedWhenReadAndWhenChecked) {
  exec(GetParam().sql);
  EXPECT_THAT(complaint(), HasSubstr(GetParam().sentence));
  EXPECT_EQ(damaged(Ledger::read(file()).check()), 1U);
}

INSTANTIATE_TEST_SUITE_P(
    All, LedgerChange,
    testing::Values(
        Change{"UPDATE attempts SET goals_blue = 9 WHERE pair = 2",
               "game equal-0002-0, attempt 1 is damaged"},
        Change{"UPDATE attempts SET started = 'now' WHERE pair = 0",
               "game equal-0000-0, attempt 1 is damaged"},
        Change{"UPDATE attempts SET wall_seconds = 15.2500000001 WHERE pair = 0",
               "game equal-0000-0, attempt 1"},
        Change{"UPDATE attempts SET checksum = NULL WHERE pair = 0", "its checksum is missing"},
        Change{"UPDATE attempts SET pair = 7 WHERE pair = 2", "game equal-0007-0, attempt 1 is damaged"},
        Change{"DELETE FROM attempts WHERE pair = 2", "it holds 3 attempts, 4 were written"},
        Change{"UPDATE audits SET hash = 'abd'", "the audit of game equal-0001-0, attempt 1 is damaged"},
        Change{"UPDATE files SET size = 6", "the row of file games/equal-0001-1/1/worker.log is damaged"},
        Change{"UPDATE experiment SET value = value || ' ' WHERE key = 'design'", "table experiment"},
        Change{"UPDATE experiment SET value = '5' WHERE key = 'attempts'", "table experiment"},
        Change{"DELETE FROM experiment WHERE key = 'checksum'", "table experiment"},
        Change{"DELETE FROM audits", "it holds 0 audits, 1 were written"},
        Change{"DELETE FROM files", "it holds 0 rows of files, 1 were written"},
        Change{"PRAGMA user_version = 1", "table experiment"},
        Change{"PRAGMA user_version = 3", "table experiment"}));

// What a ledger is made of besides its rows, looked at before any of them is read.
class LedgerShape : public LedgerChange {};

TEST_P(LedgerShape, OfAnotherFormIsDamageForReadersAndWriters) {
  exec(GetParam().sql);
  EXPECT_THAT(complaint(),
              testing::AllOf(HasSubstr("the ledger is damaged: "), HasSubstr(GetParam().sentence)));
  EXPECT_THROW(open(), StorageError);
}

INSTANTIATE_TEST_SUITE_P(
    All, LedgerShape,
    testing::Values(
        Change{"ALTER TABLE experiment RENAME TO e; CREATE VIEW experiment AS WITH RECURSIVE r(n) AS (SELECT "
               "1 UNION "
               "ALL SELECT n + 1 FROM r) SELECT CAST(n AS TEXT) AS key, '' AS value FROM r; DROP TABLE e",
               "experiment must be a table with rows of its own"},
        Change{"ALTER TABLE attempts RENAME TO e; CREATE VIEW attempts AS SELECT * FROM e",
               "attempts must be a table"},
        Change{"DROP TABLE audits; CREATE VIRTUAL TABLE audits USING rtree(id, a, b)",
               "audits must be a table"},
        Change{"CREATE TRIGGER t AFTER INSERT ON attempts BEGIN DELETE FROM attempts; END",
               "it holds the trigger t, which no ledger has"},
        Change{"CREATE VIEW v AS SELECT 1", "it holds the view v"},
        Change{"CREATE INDEX i ON attempts(length(record))", "it holds the index i"},
        Change{"CREATE TABLE more (x)", "it holds the table more"},
        Change{"DROP VIEW games; CREATE VIEW games AS SELECT * FROM attempts", "the view games was changed"},
        Change{"DROP VIEW games", "the view games is missing"},
        Change{"DROP TABLE audits", "the table audits is missing"},
        Change{"DROP TABLE files", "the table files is missing"},
        Change{"ALTER TABLE attempts ADD COLUMN more TEXT", "the columns of table attempts"},
        Change{"DROP TABLE audits; CREATE TABLE audits (condition TEXT, pair INTEGER, leg INTEGER, attempt "
               "INTEGER, "
               "verdict TEXT, hash TEXT, reason TEXT, checksum TEXT AS (hex(zeroblob(9))))",
               "the columns of table audits"},
        Change{"PRAGMA user_version = -1", "its schema is -1"}));

TEST_F(LedgerTrust, RefusesAHashThatIsNone) {
  const std::string text = "\x1b[2J<b>";
  Ledger::grow(file(), experiment_.hash, {text, experiment_.design});
  EXPECT_THAT(complaint(), HasSubstr("the experiment's hash must be 32 hexadecimal digits, not '" + text));
  EXPECT_EQ(damaged(Ledger::read(file()).check()), 1U);
}

TEST_F(LedgerTrust, CountsAuditsAndFilesThroughTheirLife) {
  {
    Ledger ledger = open();
    ledger.add(Audit{{"equal", 1, 0}, 1, Verdict::Same, "abc", "again"});
    ledger.add(Audit{{"equal", 0, 0}, 1, Verdict::Same, "abc", ""});
    ledger.forget_files("games/equal-0001-1/1");
  }
  const LedgerCheck check = Ledger::read(file()).check();
  EXPECT_EQ(check.audits.whole, 2);
  EXPECT_EQ(check.files.whole, 0);
  EXPECT_EQ(damaged(check), 0U);
  EXPECT_EQ(complaint(), "nothing thrown");
}

// Rows that are gone when somebody goes on writing are not forgotten.
TEST_F(LedgerTrust, MissingRowsStayMissingWhenMoreAreWritten) {
  exec("DELETE FROM audits");
  open().add(Audit{{"equal", 0, 0}, 1, Verdict::Same, "abc", ""});
  EXPECT_THAT(complaint(), HasSubstr("it holds 1 audits, 2 were written"));
}

// Bits of the file flipped at random, as a disk or a cable does it. A bit may be one of no meaning: of an
// unused part of a page, of a column's name. Then what is read must be what was written.
TEST_F(LedgerTrust, AFlippedBitIsNoticedOrMeansNothing) {
  const std::vector<Attempt> attempts = Ledger::read(file()).attempts();
  const std::vector<Audit> audits = Ledger::read(file()).audits();
  std::ifstream stream(file(), std::ios::binary);
  const std::string right((std::istreambuf_iterator<char>(stream)), {});
  std::mt19937_64 random(17);
  int noticed = 0;
  constexpr int times = 1000;
  for (int i = 0; i < times; ++i) {
    std::string wrong = right;
    const std::size_t bit = random() % (8 * right.size());
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << (bit % 8)));
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << wrong;
    try {
      const Ledger ledger = Ledger::read(file());
      if (damaged(ledger.check()) > 0) {
        ++noticed;
        continue;
      }
      EXPECT_EQ(ledger.attempts(), attempts) << "bit " << bit;
      EXPECT_EQ(ledger.audits(), audits) << "bit " << bit;
      EXPECT_EQ(ledger.experiment(), experiment_) << "bit " << bit;
    } catch (const StorageError&) {
      ++noticed;
    }
  }
  // A quarter of such a small file is rows and pages' structure, the rest is unused.
  EXPECT_GT(noticed, times / 20);
}

TEST_F(LedgerTrust, RowsOfOlderSchemasAreNotKnownAndNewOnesAre) {
  exec("ALTER TABLE attempts DROP COLUMN checksum");
  exec("ALTER TABLE audits DROP COLUMN checksum");
  exec("DROP TABLE files");
  exec("DELETE FROM experiment WHERE key NOT IN ('hash', 'design')");
  exec("PRAGMA user_version = 2");
  LedgerCheck check = Ledger::read(file()).check();
  EXPECT_EQ(check.attempts.unknown, 4);
  EXPECT_EQ(check.audits.unknown, 1);
  EXPECT_EQ(check.experiment.unknown, 1);
  open().add(example_attempt(5, 0));
  check = Ledger::read(file()).check();
  EXPECT_EQ(check.attempts.unknown, 4);
  EXPECT_EQ(check.attempts.whole, 1);
  EXPECT_EQ(damaged(check), 0U);
  EXPECT_EQ(Ledger::read(file()).attempts().size(), 5U);
  exec("UPDATE attempts SET checksum = NULL");
  EXPECT_THAT(complaint(), HasSubstr("its checksum is missing"));
}

TEST_F(LedgerTrust, RemembersFilesUntilTheyAreForgotten) {
  {
    Ledger ledger = open();
    ledger.add(KeptFile{"manifest.json", 3, "x"});
    ledger.add(KeptFile{"manifest.json", 4, "y"});
    EXPECT_THAT(ledger.files(), ElementsAre(KeptFile{"games/equal-0001-1/1/worker.log", 5, "abc"},
                                            KeptFile{"manifest.json", 4, "y"}));
    ledger.forget_files("games/equal-0001-1/1");
    ledger.forget_files("manifest.jso");
  }
  EXPECT_THAT(Ledger::read(file()).files(), ElementsAre(KeptFile{"manifest.json", 4, "y"}));
}

// --- numbers that no game gives, in a ledger without checksums, where nothing else stands in their way

struct Number {
  const char* path;
  const char* value;
  const char* sentence;
};
class LedgerNumber : public LedgerTrust, public testing::WithParamInterface<Number> {
 protected:
  void SetUp() override {
    LedgerTrust::SetUp();
    exec("ALTER TABLE attempts DROP COLUMN checksum");
    exec("ALTER TABLE audits DROP COLUMN checksum");
    exec("DROP TABLE files");
    exec("DELETE FROM experiment WHERE key NOT IN ('hash', 'design')");
    exec("PRAGMA user_version = 2");
  }
};

TEST_P(LedgerNumber, OutOfItsRangeIsDamageNamingFieldAndValue) {
  const std::string path = GetParam().path;
  if (path.starts_with('$')) {
    exec("UPDATE attempts SET record = json_set(record, '" + path + "', json('" + GetParam().value +
         "')) WHERE pair = 0");
  } else {
    exec("UPDATE attempts SET " + path + " = " + GetParam().value + " WHERE pair = 0");
  }
  EXPECT_THAT(complaint(), testing::AllOf(HasSubstr(GetParam().sentence), HasSubstr("cannot be read")));
}

INSTANTIATE_TEST_SUITE_P(
    All, LedgerNumber,
    testing::Values(
        Number{"$.goals.yellow", "-1",
               "field 'goals': field 'yellow' must be a whole number from 0 to 1000, not -1"},
        Number{"$.goals.blue", "1000000", "not 1000000"}, Number{"$.goals.blue", "1e300", "not 1e+300"},
        Number{"$.goals.blue", "2.5", "not 2.5"},
        Number{"$.goals.blue", "18446744073709551615", "not 184467"},
        Number{"$.goals.blue", "null", "not null"}, Number{"$.goals.blue", "\"3\"", "not \"3\""},
        Number{"$.goals", "[1,2]", "not a JSON object"}, Number{"$.ticks", "-1", "'ticks'"},
        Number{"$.wall_seconds", "-0.5", "'wall_seconds' must be a number from 0.0"},
        Number{"$.wall_seconds", "1e300", "'wall_seconds'"}, Number{"$.stoppages", "-3", "'stoppages'"},
        Number{"$.calls", "{\"PossibleGoal\": -1}", "'PossibleGoal'"},
        Number{"$.fouls.blue", "-1", "'fouls'"}, Number{"$.counters", "{\"x\": 1e300}", "'x'"},
        Number{"$.costs", "{\"x\": null}", "'x'"}, Number{"$.statistics.yellow.shots", "-1", "'shots'"},
        Number{"$.statistics.blue.possession", "-1", "'possession'"},
        Number{"$.statistics.time", "1e99", "'time'"}, Number{"$.timeline", "[{\"ns\": 1e30}]", "'ns'"},
        Number{"$.timeline", "7", "'timeline' is not a list"}, Number{"seed", "'12x'", "column seed"},
        Number{"seed", "'-1'", "column seed"}, Number{"seed", "'18446744073709551616'", "column seed"},
        Number{"attempt", "0", "column attempt must be a whole number from 1 to 3, not '0'"},
        Number{"leg", "2", "column leg must be a whole number from 0 to 1, not '2'"},
        Number{"pair", "-1", "column pair"}, Number{"pair", "1e300", "column pair"},
        Number{"a_colour", "'green'", "column a_colour must be yellow or blue, not 'green'"},
        Number{"worker", "-1", "column worker"}, Number{"record", "7", "match record: not a JSON object"},
        Number{"goals_yellow", "3", "column goals_yellow must be 2 as in the record, not '3'"}));

TEST_F(LedgerNumber, DeepJsonIsRefused) {
  const std::string deep = std::string(200, '[') + std::string(200, ']');
  exec("UPDATE attempts SET record = json_set(record, '$.timeline', json('" + deep + "')) WHERE pair = 0");
  EXPECT_THAT(complaint(), HasSubstr("nested deeper than 32"));
  // So deep that whoever goes down by recursion never comes back.
  EXPECT_THROW(match_record_from_json("{\"goals\":" + std::string(5'000'000, '[')), std::invalid_argument);
  EXPECT_THROW(match_record_from_json("{\"goals\":\"" + std::string(70'000'000, 'x') + "\"}"),
               std::invalid_argument);
}

}  // namespace
}  // namespace record
