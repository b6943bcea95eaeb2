#include "experiments/record/ledger_connection.h"

#include <stdlib.h>

#include <cctype>
#include <fstream>

#include "experiments/record/ledger_shape.h"
#include "experiments/record/ledger_tables.h"
#include "sim/files/regular_file.h"

namespace record {
namespace {

namespace fs = std::filesystem;

// Whoever reads waits for a writer in rollback mode; its transactions take milliseconds. Ours.
constexpr int reader_patience_ms = 10'000;
// The writer has a night to look after and tries again later; this is for locks that last a moment, as those
// of a reader that opens a file a killed run has left. Ours.
constexpr int writer_patience_ms = 100;

fs::path beside(const fs::path& file, const char* ending) { return file.string() + ending; }

bool has_bytes(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return !error && size > 0;
}

/// An address that tells SQLite to look at nothing but the file itself: no locks, no files beside it.
std::string immutable(const fs::path& file) {
  std::string text = "file:";
  for (const char letter : fs::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalnum(byte) != 0 || letter == '/' || letter == '.' || letter == '-' || letter == '_') {
      text += letter;
    } else {
      constexpr const char* digits = "0123456789ABCDEF";
      text += {'%', digits[byte >> 4], digits[byte & 15]};
    }
  }
  return text + "?immutable=1";
}

/// Asks for something that needs the whole way to the file: locks, and what a killed writer left.
void touch(SQLite::Database& database) {
  distrust(database);
  database.execAndGet("SELECT count(*) FROM sqlite_master");
}

/// The header says which journal belongs to the file.
bool is_write_ahead(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(18);  // "file format write version", 2 with a write-ahead log (sqlite.org/fileformat2.html)
  return stream.get() == 2;
}

bool cannot_be_written_beside(const SQLite::Exception& error) {
  return error.getErrorCode() == SQLITE_CANTOPEN || error.getErrorCode() == SQLITE_READONLY ||
         error.getErrorCode() == SQLITE_IOERR;
}

using Connection = std::unique_ptr<Ledger::Connection>;

/// SQLite opens the file and what lies beside it by their names.
void require_files(const fs::path& file) {
  for (const char* ending : {"", "-wal", "-shm", "-journal"}) {
    const fs::path one = beside(file, ending);
    if (const std::string problem = files::not_regular(one); !problem.empty()) {
      throw StorageError(one.string() + ": " + problem);
    }
  }
}

}  // namespace

PrivateCopy::PrivateCopy(const fs::path& file) {
  std::string name = (fs::temp_directory_path() / "matchday-ledger-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    throw StorageError(file.string() + ": cannot be copied to " + name + ", to be read");
  }
  folder_ = name;
  file_ = folder_ / "ledger.sqlite";
  try {
    fs::copy_file(file, file_);
    for (const char* ending : {"-wal", "-journal"}) {
      if (fs::exists(beside(file, ending))) fs::copy_file(beside(file, ending), beside(file_, ending));
    }
    for (const auto& entry : fs::directory_iterator(folder_)) {
      fs::permissions(entry, fs::perms::owner_read | fs::perms::owner_write);
    }
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    throw StorageError(file.string() + ": cannot be copied to " + name +
                       ", to be read: " + error.code().message());
  }
}

PrivateCopy::~PrivateCopy() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Connection connect_for_writing(const fs::path& file) {
  require_files(file);
  Connection connection(new Ledger::Connection{
      file.string(), nullptr,
      SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, writer_patience_ms)});
  distrust(connection->database);
  connection->database.exec("PRAGMA synchronous = FULL");
  return connection;
}

Connection connect_for_reading(const fs::path& file) {
  require_files(file);
  try {
    // Not OPEN_READONLY: what a killed writer left has to be brought to an end first.
    Connection connection(new Ledger::Connection{
        file.string(), nullptr, SQLite::Database(file.string(), SQLite::OPEN_READWRITE, reader_patience_ms)});
    touch(connection->database);
    return connection;
  } catch (const SQLite::Exception& error) {
    if (!cannot_be_written_beside(error)) throw;
  }
  // Nothing can be made beside it, so nobody writes there: it may be looked at without locks.
  if (!has_bytes(beside(file, "-wal")) && !has_bytes(beside(file, "-journal"))) {
    Connection connection(new Ledger::Connection{
        file.string(), nullptr,
        SQLite::Database(immutable(file), SQLite::OPEN_READONLY | SQLite::OPEN_URI, reader_patience_ms)});
    touch(connection->database);
    return connection;
  }
  auto copy = std::make_unique<PrivateCopy>(file);
  const fs::path copied = copy->file();
  Connection connection(new Ledger::Connection{file.string(), std::move(copy),
                                               SQLite::Database(copied.string(), SQLite::OPEN_READWRITE)});
  touch(connection->database);
  return connection;
}

void set_journal(Ledger::Connection& connection, Journal journal) {
  SQLite::Database& database = connection.database;
  if (journal == Journal::Rollback) {
    if (!is_write_ahead(connection.file)) return;
    // Alone with the file SQLite needs no shared memory to leave the write-ahead log.
    database.exec("PRAGMA locking_mode = EXCLUSIVE");
    database.execAndGet("PRAGMA journal_mode = DELETE");
    database.exec("PRAGMA locking_mode = NORMAL");
    touch(database);
    return;
  }
  database.execAndGet("PRAGMA journal_mode = WAL");
  try {
    touch(database);
  } catch (const SQLite::Exception& error) {
    if (!cannot_be_written_beside(error)) throw;
    set_journal(connection, Journal::Rollback);
  }
}

void put_together(Ledger::Connection& connection) {
  try {
    connection.database.execAndGet("PRAGMA wal_checkpoint(TRUNCATE)");
    connection.database.execAndGet("PRAGMA journal_mode = DELETE");
  } catch (const SQLite::Exception&) {
    // Somebody is reading. Nothing is lost: the last to close the file brings it together.
  }
}

Pairs checked_experiment(Ledger::Connection& connection) {
  const Pairs pairs = read_experiment(connection.database);
  if (state_of(pairs, kind_of(connection.database).version) == RowState::Damaged) {
    throw StorageError(connection.file +
                       ": the ledger is damaged: the table experiment is not what its checksum was made of");
  }
  if (const std::string problem = problem_of_hash(pairs); !problem.empty()) {
    throw StorageError(connection.file + ": the ledger is damaged: " + problem);
  }
  return pairs;
}

}  // namespace record
