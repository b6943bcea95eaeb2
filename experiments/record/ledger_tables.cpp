#include "experiments/record/ledger_tables.h"

#include "experiments/record/ledger.h"

namespace record {
namespace {

constexpr int application_id = 0x4d444159;  // "MDAY": tells our files from any other SQLite file

constexpr const char* tables = R"(
CREATE TABLE experiment (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE attempts (
  game TEXT NOT NULL,              -- condition-pair-leg
  condition TEXT NOT NULL,
  pair INTEGER NOT NULL,
  leg INTEGER NOT NULL,            -- 0: A is blue, 1: A is yellow
  attempt INTEGER NOT NULL,        -- from 1
  seed TEXT NOT NULL,              -- unsigned 64 bit, decimal
  a_colour TEXT NOT NULL,
  blue_on_positive_half INTEGER NOT NULL,
  first_kickoff TEXT NOT NULL,
  outcome TEXT NOT NULL,           -- yellow-wins, blue-wins, draw, void
  termination TEXT NOT NULL,
  at_fault TEXT NOT NULL,
  reason TEXT NOT NULL,
  goals_yellow INTEGER NOT NULL,   -- as played, before any forfeit
  goals_blue INTEGER NOT NULL,
  ticks INTEGER NOT NULL,
  hash TEXT NOT NULL,
  fouls_yellow INTEGER NOT NULL,
  fouls_blue INTEGER NOT NULL,
  stoppages INTEGER NOT NULL,
  wall_seconds REAL NOT NULL,
  worker INTEGER NOT NULL,
  started TEXT NOT NULL,           -- UTC
  record TEXT NOT NULL,            -- the whole record as JSON: calls, counters, versions, timeline, costs
  checksum TEXT,                   -- of the columns before; none in rows of schema 1 and 2
  PRIMARY KEY (condition, pair, leg, attempt)
);
)";

// Of later origin than the others: a ledger without it is one without audits.
constexpr const char* audit_table = R"(
CREATE TABLE audits (
  condition TEXT NOT NULL,
  pair INTEGER NOT NULL,
  leg INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  verdict TEXT NOT NULL,           -- same, team-differs, simulator-differs, teams-or-us-differ, failed
  hash TEXT NOT NULL,              -- of the game played again
  reason TEXT NOT NULL,
  checksum TEXT,
  PRIMARY KEY (condition, pair, leg, attempt)
);
)";

constexpr const char* file_table = R"(
CREATE TABLE files (
  path TEXT NOT NULL PRIMARY KEY,  -- seen from the result folder
  size INTEGER NOT NULL,           -- [bytes]
  contents TEXT NOT NULL,          -- XXH3-128 of its bytes
  checksum TEXT NOT NULL
);
)";

/// Attempts with their statistics as columns: everything of `attempts` but the record, then ball_in_play [s],
/// passages, longest_passage [s], and for each team what TeamStatistics has, as shots_yellow.
std::string view_of_games() {
  std::string text =
      "CREATE VIEW games AS SELECT game, condition, pair, leg, attempt, seed, a_colour, "
      "blue_on_positive_half, "
      "first_kickoff, outcome, termination, at_fault, reason, goals_yellow, goals_blue, ticks, hash, "
      "fouls_yellow, fouls_blue, stoppages, wall_seconds, worker, started";
  const auto add = [&text](const std::string& path, const std::string& name) {
    text += ", json_extract(record, '$.statistics." + path + "') AS " + name;
  };
  add("in_play", "ball_in_play");
  add("passages", "passages");
  add("longest_passage", "longest_passage");
  for (const char* key : {"kicks", "shots", "shots_on_target", "saves", "passes", "passes_completed",
                          "touches", "turnovers", "balls_out", "possession", "territory", "distance"}) {
    for (const world::Team team : world::both_teams) {
      const std::string colour = world::name(team);
      add(colour + "." + key, std::string(key) + "_" + colour);
    }
  }
  return text + " FROM attempts";
}

void set_version(SQLite::Database& database) {
  database.exec("PRAGMA user_version = " + std::to_string(Ledger::schema));
}

}  // namespace

Kind kind_of(SQLite::Database& database) {
  return {database.execAndGet("PRAGMA application_id").getInt(),
          database.execAndGet("PRAGMA user_version").getInt()};
}

void check_kind(const Kind& kind, const std::string& file) {
  if (kind.application != application_id) {
    throw StorageError(
        file + ": this is an SQLite file but not a ledger of matchday; move it away or give another --out");
  }
  if (kind.version > Ledger::schema) {
    throw StorageError(file + ": the ledger has schema " + std::to_string(kind.version) +
                       " but this program knows only up to " + std::to_string(Ledger::schema) +
                       "; use the newer matchday or give another --out");
  }
}

void check_health(SQLite::Database& database, const std::string& file) {
  const std::string health = database.execAndGet("PRAGMA quick_check(1)").getString();
  if (health != "ok") throw StorageError(file + ": the ledger is damaged: " + health);
}

void create_tables(SQLite::Database& database) {
  database.exec(tables);
  database.exec(audit_table);
  database.exec(file_table);
  database.exec(view_of_games());
  database.exec("PRAGMA application_id = " + std::to_string(application_id));
  set_version(database);
}

void upgrade_tables(SQLite::Database& database, int version) {
  if (version < 2) database.exec(view_of_games());
  if (version < 3) {
    database.exec("ALTER TABLE attempts ADD COLUMN checksum TEXT");
    if (!database.tableExists("audits")) {
      database.exec(audit_table);
    } else {
      database.exec("ALTER TABLE audits ADD COLUMN checksum TEXT");
    }
    database.exec(file_table);
    const auto count = [&](const char* table) {
      return "(SELECT CAST(count(*) AS TEXT) FROM " + std::string(table) + ")";
    };
    database.exec("INSERT OR REPLACE INTO experiment VALUES ('" + std::string(attempts_key) + "', " +
                  count("attempts") + "), ('" + old_attempts_key + "', " + count("attempts") + "), ('" +
                  old_audits_key + "', " + count("audits") + ")");
  }
  if (version < 4) {
    const auto pair = [](const char* table) {
      return "('" + std::string(table) + "', (SELECT CAST(count(*) AS TEXT) FROM " + table + "))";
    };
    database.exec("INSERT OR REPLACE INTO experiment VALUES " + pair(audits_key) + ", " + pair(files_key));
  }
  set_version(database);
}

}  // namespace record
