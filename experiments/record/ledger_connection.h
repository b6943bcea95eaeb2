#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <filesystem>
#include <memory>
#include <string>

#include "experiments/record/ledger.h"
#include "experiments/record/ledger_rows.h"

// How the file of a ledger is opened and locked, for the sources of this folder only.
namespace record {

/// A folder that goes with its owner.
class PrivateCopy {
 public:
  /// Copies a ledger with what a killed writer left beside it.
  explicit PrivateCopy(const std::filesystem::path& file);
  PrivateCopy(const PrivateCopy&) = delete;
  PrivateCopy& operator=(const PrivateCopy&) = delete;
  ~PrivateCopy();
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path folder_;
  std::filesystem::path file_;
};

struct Ledger::Connection {
  std::string file;
  std::unique_ptr<PrivateCopy> copy;  ///< where the file itself cannot be used; goes after the database
  SQLite::Database database;
};

/// Calls `action` and turns what SQLite throws into one sentence about the file.
template <class Action>
auto guarded(const std::string& file, Action action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    const std::string reason = error.what();
    switch (error.getErrorCode()) {
      case SQLITE_NOTADB:
      case SQLITE_CORRUPT:
        throw StorageError(file + ": the ledger is damaged: " + reason);
      case SQLITE_BUSY:
      case SQLITE_LOCKED:
        throw LedgerBlocked(file + ": another program holds the ledger: " + reason);
      case SQLITE_FULL:
        throw LedgerBlocked(file + ": the ledger cannot be written: " + reason);
      default:
        throw StorageError(file + ": the ledger cannot be used: " + reason);
    }
  }
}

std::unique_ptr<Ledger::Connection> connect_for_writing(const std::filesystem::path& file);
std::unique_ptr<Ledger::Connection> connect_for_reading(const std::filesystem::path& file);

/// Takes up this way of writing; where the file system has no shared memory, it stays with the other.
void set_journal(Ledger::Connection& connection, Journal journal);

/// Everything into one file again, in rollback mode, if nobody else holds it.
void put_together(Ledger::Connection& connection);

/// The table `experiment`.
/// @throws StorageError when it is not what was written
Pairs checked_experiment(Ledger::Connection& connection);

}  // namespace record
