#include "experiments/record/ledger_shape.h"

#include <sqlite3.h>

#include <map>
#include <set>
#include <vector>

#include "experiments/record/ledger.h"
#include "experiments/record/ledger_tables.h"

namespace record {
namespace {

constexpr int longest_value =
    128 << 20;  // [bytes] ours: twice the longest record that is read (json_fields.h)

struct Entry {
  std::string kind;  ///< "table", "view", "index", "trigger"
  bool stored =
      false;  ///< has pages of its own; a virtual table has none, its rows are computed by a program
  std::string sql;
};

std::map<std::string, Entry> entries_of(SQLite::Database& database) {
  std::map<std::string, Entry> entries;
  SQLite::Statement rows(database, "SELECT name, type, rootpage, sql FROM sqlite_master");
  while (rows.executeStep()) {
    entries[rows.getColumn(0).getString()] = {rows.getColumn(1).getString(), rows.getColumn(2).getInt64() > 0,
                                              rows.getColumn(3).getString()};
  }
  return entries;
}

/// Name, type and properties of every column; the default and the last one, whether it is computed, as well.
std::vector<std::string> columns_of(SQLite::Database& database, const std::string& table) {
  std::vector<std::string> columns;
  SQLite::Statement rows(
      database,
      "SELECT name, type, \"notnull\", dflt_value, pk, hidden FROM pragma_table_xinfo('" + table + "')");
  while (rows.executeStep()) {
    std::string text;
    for (int i = 0; i < rows.getColumnCount(); ++i) text += rows.getColumn(i).getString() + "|";
    columns.push_back(text);
  }
  return columns;
}

std::set<std::string> names_needed(int version) {
  std::set<std::string> names = {"experiment", "attempts"};
  if (version >= 2) names.insert("games");
  if (version >= 3) names.insert({"audits", "files"});
  return names;
}

}  // namespace

void distrust(SQLite::Database& database) {
  sqlite3* handle = database.getHandle();
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, longest_value);
  database.exec("PRAGMA ignore_check_constraints = ON");  // a ledger has none
}

void check_shape(SQLite::Database& database, int version, const std::string& file) {
  const auto wrong = [&](const std::string& problem) {
    throw StorageError(file + ": the ledger is damaged: " + problem);
  };
  if (version < 1) wrong("its schema is " + std::to_string(version));
  SQLite::Database pattern(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  create_tables(pattern);
  const std::map<std::string, Entry> ours = entries_of(pattern);
  const std::map<std::string, Entry> found = entries_of(database);
  for (const std::string& name : names_needed(version)) {
    if (!found.contains(name)) wrong("the " + ours.at(name).kind + " " + name + " is missing");
  }
  for (const auto& [name, entry] : found) {
    if (name.starts_with("sqlite_")) continue;  // SQLite's own, which nobody else can make
    const auto known = ours.find(name);
    if (known == ours.end()) wrong("it holds the " + entry.kind + " " + name + ", which no ledger has");
    if (known->second.kind != entry.kind || known->second.stored != entry.stored) {
      wrong(name + " must be a " + known->second.kind + " with rows of its own, as matchday makes it");
    }
    if (entry.kind == "view" && entry.sql != known->second.sql) wrong("the view " + name + " was changed");
    if (entry.kind != "table") continue;
    std::vector<std::string> columns = columns_of(database, name);
    const std::vector<std::string> right = columns_of(pattern, name);
    // Before schema 3 no row had a checksum, which is the last column.
    const bool older = version < 3 && columns.size() + 1 == right.size();
    if (older) columns.push_back(right.back());
    if (columns != right) wrong("the columns of table " + name + " are not those that matchday makes");
  }
}

}  // namespace record
