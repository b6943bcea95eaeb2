#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

// What may be in the file of a ledger, for the sources of this folder only.
namespace record {

/// Settings of a connection to a file that somebody else may have made: nothing that is stored in it is run.
void distrust(SQLite::Database& database);

/// Compares the names, kinds and columns in the file with those that a ledger of that schema has. Reads the
/// list of names only: what stands in the place of a table may be a view whose rows never end.
///
/// @throws StorageError naming what is missing or should not be there
void check_shape(SQLite::Database& database, int version, const std::string& file);

}  // namespace record
