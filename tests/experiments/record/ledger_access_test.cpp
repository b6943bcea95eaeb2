// Several programs at one ledger, killed writers, folders that cannot be written.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iostream>

#include "experiments/record/ledger.h"
#include "tests/experiments/record/examples.h"

namespace record {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class LedgerAccess : public testing::TestWithParam<Journal> {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "ledger-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    fs::permissions(folder_, fs::perms(0755));
  }
  void TearDown() override {
    fs::permissions(folder_, fs::perms(0755));
    fs::remove_all(folder_);
  }

  fs::path file() const { return folder_ / "ledger.sqlite"; }
  Ledger open(Journal journal) const { return Ledger::open(file(), experiment_, journal); }
  Ledger open() const { return open(GetParam()); }
  bool there(const char* ending) const { return fs::exists(file().string() + ending); }
  SQLite::Database other() const { return SQLite::Database(file().string(), SQLite::OPEN_READWRITE); }

  /// A writer with two rows that is killed.
  void kill_a_writer(Journal journal) const {
    const pid_t child = ::fork();
    if (child == 0) {
      try {
        Ledger ledger = open(journal);
        ledger.add(example_attempt(0, 0));
        ledger.add(example_attempt(0, 1));
        ::raise(SIGKILL);
      } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
      }
      ::_exit(1);
    }
    ::waitpid(child, nullptr, 0);
  }

  /// How many attempts somebody sees who may write nothing there; -1: a complaint.
  int seen_by_a_stranger() const {
    const pid_t child = ::fork();
    if (child == 0) {
      if (::geteuid() == 0 && ::setresuid(65534, 65534, 65534) != 0) ::_exit(255);
      try {
        ::_exit(static_cast<int>(Ledger::read(file()).attempts().size()));
      } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        ::_exit(255);
      }
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WEXITSTATUS(status);
    return WIFEXITED(status) && code != 255 ? code : -1;
  }
  void close_folder() const {
    for (const auto& entry : fs::directory_iterator(folder_)) fs::permissions(entry, fs::perms(0444));
    fs::permissions(folder_, fs::perms(0555));
  }

  fs::path folder_;
  Experiment experiment_{"00112233445566778899aabbccddeeff", "name = \"test\"\n"};
};
using LedgerReaders = LedgerAccess;

TEST_F(LedgerReaders, InTheMiddleOfAQueryNeverBlockTheWriter) {
  Ledger ledger = open(Journal::WriteAhead);
  ledger.add(example_attempt(0, 0));
  ledger.add(example_attempt(0, 1));
  SQLite::Database database = other();
  SQLite::Statement rows(database, "SELECT game FROM attempts");
  ASSERT_TRUE(rows.executeStep());
  ledger.add(example_attempt(1, 0));
  EXPECT_EQ(ledger.attempts().size(), 3U);
  EXPECT_EQ(Ledger::read(file()).attempts().size(), 3U);
  ledger.put_together();  // cannot, and does no harm
  ledger.add(example_attempt(1, 1));
  EXPECT_TRUE(rows.executeStep());
  EXPECT_FALSE(rows.executeStep()) << "it sees what was there when it began";
}

TEST_P(LedgerAccess, AnotherWriterBlocksItForAWhileAndNothingIsHalfWritten) {
  Ledger ledger = open();
  SQLite::Database database = other();
  database.exec("BEGIN IMMEDIATE");
  EXPECT_THROW(ledger.add(example_attempt(0, 0)), LedgerBlocked);
  EXPECT_THROW(ledger.add(Audit{}), LedgerBlocked);
  EXPECT_THROW(ledger.add(KeptFile{}), LedgerBlocked);
  database.exec("ROLLBACK");
  EXPECT_TRUE(ledger.attempts().empty());
  ledger.add(example_attempt(0, 0));
  EXPECT_EQ(ledger.attempts().size(), 1U);
}

TEST_P(LedgerAccess, IsNotOpenedWhileAnotherProgramHoldsAllOfIt) {
  open().add(example_attempt(0, 0));
  {
    SQLite::Database database = other();
    database.exec("PRAGMA locking_mode = EXCLUSIVE");
    database.exec("BEGIN EXCLUSIVE");
    EXPECT_THROW(open(), LedgerBlocked);
  }
  EXPECT_EQ(open().attempts().size(), 1U);
}

TEST_P(LedgerAccess, IsOneFileWhenItIsClosed) {
  open().add(example_attempt(0, 0));
  EXPECT_FALSE(there("-wal"));
  EXPECT_FALSE(there("-shm"));
  EXPECT_FALSE(there("-journal"));
}

TEST_P(LedgerAccess, OfAKilledWriterHasEveryRowForReadersAndTheNextRun) {
  kill_a_writer(GetParam());
  EXPECT_EQ(there("-wal"), GetParam() == Journal::WriteAhead);
  EXPECT_EQ(Ledger::read(file()).attempts().size(), 2U);
  open().add(example_attempt(1, 0));
  EXPECT_EQ(Ledger::read(file()).attempts().size(), 3U);
}

TEST_P(LedgerAccess, IsReadByWhoMayNotWriteThere) {
  {
    Ledger ledger = open();
    ledger.add(example_attempt(0, 0));
    EXPECT_EQ(seen_by_a_stranger(), 1) << "while it is written";
  }
  close_folder();
  EXPECT_EQ(seen_by_a_stranger(), 1) << "closed";
  fs::permissions(folder_, fs::perms(0755));
  fs::permissions(file(), fs::perms(0644));
  open().put_together();
  close_folder();
  EXPECT_EQ(seen_by_a_stranger(), 1) << "put together";
}

TEST_P(LedgerAccess, OfAKilledWriterIsReadByWhoMayNotWriteThere) {
  kill_a_writer(GetParam());
  EXPECT_EQ(seen_by_a_stranger(), 2) << "in a folder of somebody else";
  close_folder();
  EXPECT_EQ(seen_by_a_stranger(), 2) << "on a medium that cannot be written";
  EXPECT_EQ(there("-wal"), GetParam() == Journal::WriteAhead) << "nothing is touched";
  fs::permissions(folder_, fs::perms(0755));
  fs::remove(file().string() + "-shm");
  close_folder();
  EXPECT_EQ(seen_by_a_stranger(), 2) << "copied without its -shm";
}

TEST_F(LedgerReaders, AHotRollbackJournalIsReadFromAMediumThatCannotBeWritten) {
  {
    Ledger ledger = open(Journal::Rollback);
    ledger.add(example_attempt(0, 0));
    ledger.put_together();
  }
  const pid_t child = ::fork();
  if (child == 0) {
    SQLite::Database database = other();
    database.exec("PRAGMA cache_size = 1");  // pages go to the file before the commit
    database.exec("BEGIN");
    database.exec("UPDATE attempts SET record = record || printf('%.*c', 200000, 'x')");
    database.exec("DELETE FROM attempts");
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  ASSERT_TRUE(there("-journal"));
  close_folder();
  EXPECT_EQ(seen_by_a_stranger(), 1);
  EXPECT_TRUE(there("-journal"));
}

TEST_F(LedgerReaders, ALedgerThatComesToANetworkFileSystemLeavesTheWriteAheadLog) {
  kill_a_writer(Journal::WriteAhead);
  Ledger ledger = open(Journal::Rollback);
  ledger.add(example_attempt(1, 0));
  EXPECT_FALSE(there("-wal"));
  EXPECT_FALSE(there("-shm"));
  EXPECT_EQ(other().execAndGet("PRAGMA journal_mode").getString(), "delete");
  EXPECT_EQ(Ledger::read(file()).attempts().size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(Journals, LedgerAccess, testing::Values(Journal::WriteAhead, Journal::Rollback),
                         [](const auto& instance) {
                           return instance.param == Journal::WriteAhead ? "WriteAhead" : "Rollback";
                         });

}  // namespace
}  // namespace record
