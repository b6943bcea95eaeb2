#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

// The tables of a ledger, for the sources of this folder only.
namespace record {

/// What the file is, as far as its header tells.
struct Kind {
  int application = 0;
  int version = 0;
};
Kind kind_of(SQLite::Database& database);

/// @throws StorageError when it is no ledger or one of a newer schema
void check_kind(const Kind& kind, const std::string& file);

/// @throws StorageError when SQLite finds its pages damaged
void check_health(SQLite::Database& database, const std::string& file);

/// Makes all tables in an empty file; the caller's transaction.
void create_tables(SQLite::Database& database);

/// Brings a ledger of an older schema up to date, leaving its rows as they are; the caller's transaction.
void upgrade_tables(SQLite::Database& database, int version);

// Keys of the table `experiment`.
inline constexpr const char* hash_key = "hash";
inline constexpr const char* design_key = "design";
inline constexpr const char* attempts_key = "attempts";  ///< how many rows were ever written
inline constexpr const char* audits_key = "audits";      ///< how many rows the table of that name has
inline constexpr const char* files_key = "files";        ///< the same
inline constexpr const char* old_attempts_key = "attempts_without_checksum";
inline constexpr const char* old_audits_key = "audits_without_checksum";
inline constexpr const char* checksum_key = "checksum";  ///< of all others, by key

}  // namespace record
