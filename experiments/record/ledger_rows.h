#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <string>
#include <vector>

#include "experiments/record/attempt.h"
#include "experiments/record/audit.h"
#include "experiments/record/checksum.h"
#include "experiments/record/kept_file.h"
#include "experiments/record/ledger.h"

// Rows of a ledger to values and back, for the sources of this folder only.
namespace record {

/// A row of a table: its columns but the checksum, in the table's order.
using Row = std::vector<Value>;

Row row_of(const Attempt& attempt);
Row row_of(const Audit& audit);
Row row_of(const KeptFile& file);

/// Writes a row with its checksum; `verb` is INSERT or INSERT OR REPLACE.
void write_row(SQLite::Database& database, const char* verb, const char* table, const Row& row);

/// What is found when a row is looked at.
enum class RowState {
  Whole,    ///< its checksum is that of its contents
  Unknown,  ///< it has none: written before schema 3
  Damaged
};

/// A table read row by row.
class RowReader {
 public:
  /// @param order  SQL after ORDER BY
  RowReader(SQLite::Database& database, const char* table, const char* order);

  bool next();
  const Row& row() const { return row_; }
  RowState state() const { return state_; }

 private:
  const char* table_;
  bool signed_;  ///< the table has checksums
  SQLite::Statement statement_;
  Row row_;
  RowState state_ = RowState::Unknown;
};

/// "game equal-0003-1, attempt 1", as far as the row can be read.
std::string place_of(const Row& row, const char* table);

/// @throws std::invalid_argument naming column and value when it is out of its range
Attempt attempt_of(const Row& row, Detail detail);
Audit audit_of(const Row& row);
KeptFile file_of(const Row& row);

/// The table `experiment`.
using Pairs = std::map<std::string, std::string>;
Pairs read_experiment(SQLite::Database& database);
/// Writes all of it, with its checksum.
void write_experiment(SQLite::Database& database, Pairs pairs);
/// Why the experiment's hash there is none; empty: it is one.
std::string problem_of_hash(const Pairs& pairs);
/// Whether its checksum is that of its contents; of an older schema it has none, nor any key of a newer one.
RowState state_of(const Pairs& pairs, int version);
/// A number there, 0 when there is none.
/// @throws std::invalid_argument when it is no number
std::int64_t number_in(const Pairs& pairs, const char* key);

inline constexpr const char* attempt_order = "condition, pair, leg, attempt";

}  // namespace record
