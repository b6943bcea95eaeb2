#include "experiments/record/ledger.h"

#include <limits>
#include <type_traits>
#include <utility>

#include "experiments/record/ledger_connection.h"
#include "experiments/record/ledger_rows.h"
#include "experiments/record/ledger_shape.h"
#include "experiments/record/ledger_tables.h"

namespace record {
namespace {

using SQLite::Transaction;

/// A row of `table` that cannot be used; `problem` says why.
StorageError unusable(const std::string& file, const Row& row, const char* table,
                      const std::string& problem) {
  return StorageError(file + ": " + place_of(row, table) + " " + problem);
}

constexpr std::int64_t any_number = std::numeric_limits<std::int64_t>::max();
constexpr std::string_view not_as_written = "is damaged: its contents are not those its checksum was made of";

/// Every row of a table as a value.
template <class Read>
auto all_rows(SQLite::Database& database, const std::string& file, const char* table, const char* order,
              std::int64_t old_rows, Read read) {
  std::vector<std::invoke_result_t<Read, const Row&>> all;
  std::int64_t unknown = 0;
  RowReader rows(database, table, order);
  while (rows.next()) {
    if (rows.state() == RowState::Damaged)
      throw unusable(file, rows.row(), table, std::string(not_as_written));
    if (rows.state() == RowState::Unknown && ++unknown > old_rows) {
      throw unusable(file, rows.row(), table, "is damaged: its checksum is missing");
    }
    try {
      all.push_back(read(rows.row()));
    } catch (const std::logic_error& error) {
      throw unusable(file, rows.row(), table, std::string("cannot be read: ") + error.what());
    }
  }
  return all;
}

/// How many rows may be without a checksum.
std::int64_t old_rows(SQLite::Database& database, const Pairs& pairs, const char* key) {
  return kind_of(database).version < 3 ? any_number : number_in(pairs, key);
}

/// What is wrong with the number of rows in a table; empty: nothing, or an older ledger does not tell it.
std::string rows_missing(const Pairs& pairs, int version, const std::string& table, std::int64_t found) {
  if (version < (table == attempts_key ? 3 : 4)) return {};
  const std::int64_t written = number_in(pairs, table.c_str());
  if (found == written) return {};
  return "the ledger is damaged: it holds " + std::to_string(found) +
         (table == files_key ? " rows of files" : " " + table) + ", " + std::to_string(written) +
         " were written";
}

void check_number(Ledger::Connection& connection, const Pairs& pairs, const char* table, std::size_t found) {
  const std::string problem =
      rows_missing(pairs, kind_of(connection.database).version, table, static_cast<std::int64_t>(found));
  if (!problem.empty()) throw StorageError(connection.file + ": " + problem);
}

std::int64_t rows_in(SQLite::Database& database, const char* table) {
  return database.execAndGet("SELECT count(*) FROM " + std::string(table)).getInt64();
}

/// One transaction in which audits and files may come and go; the table `experiment` counts them.
///
/// @param also  what else is to be changed there
template <class Change, class Also>
void change_rows(SQLite::Database& database, Change change, Also also) {
  Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  Pairs pairs = read_experiment(database);
  // By their difference: rows that were missing before stay missing.
  const auto count = [&](std::int64_t sign) {
    for (const char* table : {audits_key, files_key})
      pairs[table] = std::to_string(number_in(pairs, table) + sign * rows_in(database, table));
  };
  count(-1);
  change();
  count(1);
  also(pairs);
  write_experiment(database, std::move(pairs));
  transaction.commit();
}

template <class Change>
void change_rows(SQLite::Database& database, Change change) {
  change_rows(database, change, [](Pairs&) {});
}

}  // namespace

Ledger::Ledger(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
Ledger::Ledger(Ledger&&) noexcept = default;
Ledger& Ledger::operator=(Ledger&&) noexcept = default;
Ledger::~Ledger() = default;

Ledger Ledger::open(const std::filesystem::path& path, const Experiment& experiment, Journal journal) {
  return guarded(path.string(), [&] {
    std::unique_ptr<Connection> connection = connect_for_writing(path);
    SQLite::Database& database = connection->database;
    // A run killed before its first commit leaves a file without tables: begin anew.
    if (database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0) {
      Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      create_tables(database);
      write_experiment(database, {{hash_key, experiment.hash},
                                  {design_key, experiment.design},
                                  {attempts_key, "0"},
                                  {audits_key, "0"},
                                  {files_key, "0"}});
      transaction.commit();
    }
    const Kind kind = kind_of(database);
    check_kind(kind, connection->file);
    check_shape(database, kind.version, connection->file);
    check_health(database, connection->file);
    Ledger ledger(std::move(connection));
    const std::string found = ledger.experiment().hash;
    if (found != experiment.hash) {
      throw FolderTaken(path.string() + ": holds experiment " + found +
                        " but the design, its programs and their files make " + experiment.hash +
                        "; give another --out, or restore what was changed");
    }
    if (kind.version < schema) {
      Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      upgrade_tables(database, kind.version);
      write_experiment(database, read_experiment(database));
      transaction.commit();
    }
    set_journal(*ledger.connection_, journal);
    return ledger;
  });
}

void Ledger::grow(const std::filesystem::path& path, const std::string& before, const Experiment& larger,
                  const std::string& forgotten, Journal journal) {
  const Ledger ledger = open(path, {before, larger.design}, journal);
  guarded(path.string(), [&] {
    SQLite::Database& database = ledger.connection_->database;
    const auto forget = [&] {
      SQLite::Statement remove(database, "DELETE FROM files WHERE path = ?");
      remove.bind(1, forgotten);
      remove.exec();
    };
    change_rows(database, forget, [&](Pairs& pairs) {
      pairs[hash_key] = larger.hash;
      pairs[design_key] = larger.design;
    });
  });
}

Ledger Ledger::read(const std::filesystem::path& path) {
  if (!std::filesystem::exists(path)) {
    throw StorageError(path.string() +
                       ": there is no ledger; is this the result folder of a 'matchday run'?");
  }
  return guarded(path.string(), [&] {
    std::unique_ptr<Connection> connection = connect_for_reading(path);
    if (connection->database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0) {
      throw StorageError(path.string() + ": the ledger is still empty; start the run again");
    }
    const Kind kind = kind_of(connection->database);
    check_kind(kind, connection->file);
    check_shape(connection->database, kind.version, connection->file);
    check_health(connection->database, connection->file);
    return Ledger(std::move(connection));
  });
}

void Ledger::add(const Attempt& attempt, std::span<const KeptFile> files) {
  guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    const auto write = [&] {
      write_row(database, "INSERT", "attempts", row_of(attempt));
      for (const KeptFile& file : files) write_row(database, "INSERT OR REPLACE", "files", row_of(file));
    };
    change_rows(database, write, [](Pairs& pairs) {
      pairs[attempts_key] = std::to_string(number_in(pairs, attempts_key) + 1);
    });
  });
}

void Ledger::add(const Audit& audit) {
  guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    change_rows(database, [&] { write_row(database, "INSERT OR REPLACE", "audits", row_of(audit)); });
  });
}

void Ledger::add(const KeptFile& file) {
  guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    change_rows(database, [&] { write_row(database, "INSERT OR REPLACE", "files", row_of(file)); });
  });
}

void Ledger::forget_files(const std::string& folder) {
  guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    change_rows(database, [&] {
      SQLite::Statement remove(database, "DELETE FROM files WHERE substr(path, 1, length(?1)) = ?1");
      remove.bind(1, folder + "/");
      remove.exec();
    });
  });
}

std::vector<Attempt> Ledger::attempts(Detail detail) const {
  return guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    Transaction snapshot(database);  // a writer may add a row between two questions
    const Pairs pairs = checked_experiment(*connection_);
    std::vector<Attempt> attempts = all_rows(database, connection_->file, "attempts", attempt_order,
                                             old_rows(database, pairs, old_attempts_key),
                                             [&](const Row& row) { return attempt_of(row, detail); });
    check_number(*connection_, pairs, attempts_key, attempts.size());
    return attempts;
  });
}

std::vector<Audit> Ledger::audits() const {
  return guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    if (!database.tableExists("audits")) return std::vector<Audit>{};
    Transaction snapshot(database);
    const Pairs pairs = checked_experiment(*connection_);
    std::vector<Audit> audits = all_rows(database, connection_->file, "audits", attempt_order,
                                         old_rows(database, pairs, old_audits_key), audit_of);
    check_number(*connection_, pairs, audits_key, audits.size());
    return audits;
  });
}

std::vector<KeptFile> Ledger::files() const {
  return guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    if (!database.tableExists("files")) return std::vector<KeptFile>{};
    Transaction snapshot(database);
    const Pairs pairs = checked_experiment(*connection_);
    std::vector<KeptFile> files = all_rows(database, connection_->file, "files", "path", 0, file_of);
    check_number(*connection_, pairs, files_key, files.size());
    return files;
  });
}

Experiment Ledger::experiment() const {
  return guarded(connection_->file, [&] {
    const Pairs pairs = checked_experiment(*connection_);
    const auto value = [&](const char* key) {
      const auto found = pairs.find(key);
      return found == pairs.end() ? std::string() : found->second;
    };
    return Experiment{value(hash_key), value(design_key)};
  });
}

int Ledger::version() const {
  return guarded(connection_->file, [&] { return kind_of(connection_->database).version; });
}

LedgerCheck Ledger::check() const {
  return guarded(connection_->file, [&] {
    SQLite::Database& database = connection_->database;
    Transaction snapshot(database);
    const int kind = kind_of(database).version;
    const Pairs pairs = read_experiment(database);
    const RowState state = state_of(pairs, kind);
    const bool known = state == RowState::Whole;
    LedgerCheck check;
    const auto look = [&](const char* table, const char* order, std::int64_t old, RowCheck& rows,
                          const auto& read) {
      std::int64_t found = 0;
      if (!database.tableExists(table)) return;
      RowReader reader(database, table, order);
      for (; reader.next(); ++found) {
        const std::string place = place_of(reader.row(), table);
        if (reader.state() == RowState::Damaged) {
          rows.damaged.push_back(place + " " + std::string(not_as_written));
          continue;
        }
        try {
          read(reader.row());
        } catch (const std::logic_error& error) {
          rows.damaged.push_back(place + " cannot be read: " + error.what());
          continue;
        }
        ++(reader.state() == RowState::Whole ? rows.whole : rows.unknown);
      }
      if (kind >= 3 && rows.unknown > old) {
        rows.damaged.push_back(std::to_string(rows.unknown - old) + " rows of table " + table +
                               " have lost their checksum");
      }
      // Without its own table the rest is compared as far as it goes.
      const std::string missing = known ? rows_missing(pairs, kind, table, found) : "";
      if (!missing.empty()) rows.damaged.push_back(missing);
    };
    if (state == RowState::Whole) check.experiment.whole = 1;
    if (state == RowState::Unknown) check.experiment.unknown = 1;
    if (state == RowState::Damaged) {
      check.experiment.damaged.push_back("the table experiment " + std::string(not_as_written));
    } else if (const std::string problem = problem_of_hash(pairs); !problem.empty()) {
      check.experiment.damaged.push_back(problem);
    }
    const auto old = [&](const char* key) { return known ? number_in(pairs, key) : any_number; };
    look("attempts", attempt_order, old(old_attempts_key), check.attempts, [&](const Row& row) {
      check.readable_attempts.push_back(attempt_of(row, Detail::WithoutTimeline));
    });
    look("audits", attempt_order, old(old_audits_key), check.audits,
         [&](const Row& row) { check.readable_audits.push_back(audit_of(row)); });
    look("files", "path", 0, check.files,
         [&](const Row& row) { check.readable_files.push_back(file_of(row)); });
    return check;
  });
}

void Ledger::put_together() { record::put_together(*connection_); }

}  // namespace record
