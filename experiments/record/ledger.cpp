#include "experiments/record/ledger.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <sqlite3.h>

#include <optional>

namespace record {
namespace {

constexpr int application_id = 0x4d444159;  // "MDAY": tells our files from any other SQLite file
constexpr int busy_timeout_ms = 10'000;     // ours: a reader holds the file for milliseconds

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
  PRIMARY KEY (condition, pair, leg, attempt)
);
)";

// Of later origin than the others: a ledger without it is one without audits.
constexpr const char* audit_table = R"(
CREATE TABLE IF NOT EXISTS audits (
  condition TEXT NOT NULL,
  pair INTEGER NOT NULL,
  leg INTEGER NOT NULL,
  attempt INTEGER NOT NULL,
  verdict TEXT NOT NULL,           -- same, team-differs, simulator-differs, teams-or-us-differ, failed
  hash TEXT NOT NULL,              -- of the game played again
  reason TEXT NOT NULL,
  PRIMARY KEY (condition, pair, leg, attempt)
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

world::Team colour(const std::string& word) {
  return word == world::name(world::Team::Blue) ? world::Team::Blue : world::Team::Yellow;
}

/// What the file is, as far as its header tells.
struct Kind {
  int application = 0;
  int version = 0;
};

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

/// Calls `action` and turns what SQLite throws into one sentence about the file.
template <class Action>
auto guarded(const std::string& file, Action action) {
  try {
    return action();
  } catch (const SQLite::Exception& error) {
    const std::string reason = error.what();
    const bool damaged = error.getErrorCode() == SQLITE_NOTADB || error.getErrorCode() == SQLITE_CORRUPT;
    throw StorageError(file + (damaged ? ": the ledger is damaged: " : ": the ledger cannot be used: ") +
                       reason);
  }
}

}  // namespace

struct Ledger::Connection {
  std::string file;
  SQLite::Database database;
};

Ledger::Ledger(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
Ledger::Ledger(Ledger&&) noexcept = default;
Ledger& Ledger::operator=(Ledger&&) noexcept = default;
Ledger::~Ledger() = default;

Ledger Ledger::open(const std::filesystem::path& path, const Experiment& experiment) {
  const std::string file = path.string();
  return guarded(file, [&] {
    auto connection = std::unique_ptr<Connection>(new Connection{
        file, SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_timeout_ms)});
    SQLite::Database& database = connection->database;
    database.exec("PRAGMA synchronous = FULL");
    // A run killed before its first commit leaves a file without tables: begin anew.
    const bool fresh = database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
    if (fresh) {
      SQLite::Transaction transaction(database);
      database.exec(tables);
      database.exec(view_of_games());
      SQLite::Statement insert(database, "INSERT INTO experiment VALUES ('hash', ?), ('design', ?)");
      insert.bind(1, experiment.hash);
      insert.bind(2, experiment.design);
      insert.exec();
      database.exec("PRAGMA application_id = " + std::to_string(application_id));
      database.exec("PRAGMA user_version = " + std::to_string(schema));
      transaction.commit();
    }
    check_kind(kind_of(database), file);
    check_health(database, file);
    if (!database.tableExists("audits")) database.exec(audit_table);
    Ledger ledger(std::move(connection));
    const std::string found = ledger.experiment().hash;
    if (found != experiment.hash) {
      throw FolderTaken(file + ": holds experiment " + found +
                        " but the design, its programs and their files make " + experiment.hash +
                        "; give another --out, or restore what was changed");
    }
    if (kind_of(database).version < schema) {
      SQLite::Transaction transaction(database);
      database.exec(view_of_games());
      database.exec("PRAGMA user_version = " + std::to_string(schema));
      transaction.commit();
    }
    return ledger;
  });
}

void Ledger::grow(const std::filesystem::path& path, const std::string& before, const Experiment& larger) {
  const Ledger ledger = open(path, {before, larger.design});
  guarded(path.string(), [&] {
    SQLite::Database& database = ledger.connection_->database;
    SQLite::Transaction transaction(database);
    SQLite::Statement update(database, "INSERT OR REPLACE INTO experiment VALUES ('hash', ?), ('design', ?)");
    update.bind(1, larger.hash);
    update.bind(2, larger.design);
    update.exec();
    transaction.commit();
  });
}

Ledger Ledger::read(const std::filesystem::path& path) {
  const std::string file = path.string();
  if (!std::filesystem::exists(path)) {
    throw StorageError(file + ": there is no ledger; is this the result folder of a 'matchday run'?");
  }
  return guarded(file, [&] {
    // Not OPEN_READONLY: a writer killed in mid-commit leaves a journal that has to be rolled back first.
    auto connection = std::unique_ptr<Connection>(
        new Connection{file, SQLite::Database(file, SQLite::OPEN_READWRITE, busy_timeout_ms)});
    if (connection->database.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0) {
      throw StorageError(file + ": the ledger is still empty; start the run again");
    }
    check_kind(kind_of(connection->database), file);
    check_health(connection->database, file);
    return Ledger(std::move(connection));
  });
}

void Ledger::add(const Attempt& attempt) {
  guarded(connection_->file, [&] {
    SQLite::Transaction transaction(connection_->database);
    SQLite::Statement insert(connection_->database,
                             "INSERT INTO attempts VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
    const MatchRecord& record = attempt.record;
    int column = 0;
    insert.bind(++column, game_id(attempt.key));
    insert.bind(++column, attempt.key.condition);
    insert.bind(++column, attempt.key.pair);
    insert.bind(++column, attempt.key.leg);
    insert.bind(++column, attempt.attempt);
    insert.bind(++column, std::to_string(attempt.seed));
    insert.bind(++column, world::name(attempt.a_colour));
    insert.bind(++column, attempt.blue_on_positive_half ? 1 : 0);
    insert.bind(++column, world::name(attempt.first_kickoff));
    insert.bind(++column, name(outcome(record)));
    insert.bind(++column, name(record.termination));
    insert.bind(++column, name(record.at_fault));
    insert.bind(++column, record.reason);
    insert.bind(++column, record.goals.yellow);
    insert.bind(++column, record.goals.blue);
    insert.bind(++column, record.ticks);
    insert.bind(++column, record.hash);
    insert.bind(++column, record.fouls.yellow);
    insert.bind(++column, record.fouls.blue);
    insert.bind(++column, record.stoppages);
    insert.bind(++column, record.wall_seconds);
    insert.bind(++column, attempt.worker);
    insert.bind(++column, attempt.started);
    insert.bind(++column, to_json(record));
    insert.exec();
    transaction.commit();
  });
}

namespace {
// What is no JSON is given as it is, so that whoever reads it can name the game.
constexpr const char* without_timeline =
    "CASE WHEN json_valid(record) THEN json_set(record, '$.timeline', json_array()) ELSE record END";
}  // namespace

std::vector<Attempt> Ledger::attempts(Detail detail) const {
  return guarded(connection_->file, [&] {
    std::vector<Attempt> attempts;
    SQLite::Statement rows(
        connection_->database,
        std::string("SELECT condition, pair, leg, attempt, seed, a_colour, blue_on_positive_half, "
                    "first_kickoff, worker, started, ") +
            (detail == Detail::Whole ? "record" : without_timeline) +
            " FROM attempts ORDER BY condition, pair, leg, attempt");
    while (rows.executeStep()) {
      Attempt attempt;
      attempt.key = {rows.getColumn(0).getString(), rows.getColumn(1).getInt(), rows.getColumn(2).getInt()};
      attempt.attempt = rows.getColumn(3).getInt();
      attempt.a_colour = colour(rows.getColumn(5).getString());
      attempt.blue_on_positive_half = rows.getColumn(6).getInt() != 0;
      attempt.first_kickoff = colour(rows.getColumn(7).getString());
      attempt.worker = rows.getColumn(8).getInt();
      attempt.started = rows.getColumn(9).getString();
      try {
        attempt.seed = std::stoull(rows.getColumn(4).getString());
        attempt.record = match_record_from_json(rows.getColumn(10).getString());
      } catch (const std::logic_error& error) {
        throw StorageError(connection_->file + ": game " + game_id(attempt.key) + ", attempt " +
                           std::to_string(attempt.attempt) + " cannot be read: " + error.what());
      }
      attempts.push_back(std::move(attempt));
    }
    return attempts;
  });
}

void Ledger::add(const Audit& audit) {
  guarded(connection_->file, [&] {
    SQLite::Statement insert(connection_->database, "INSERT OR REPLACE INTO audits VALUES (?,?,?,?,?,?,?)");
    insert.bind(1, audit.key.condition);
    insert.bind(2, audit.key.pair);
    insert.bind(3, audit.key.leg);
    insert.bind(4, audit.attempt);
    insert.bind(5, name(audit.verdict));
    insert.bind(6, audit.hash);
    insert.bind(7, audit.reason);
    insert.exec();
  });
}

std::vector<Audit> Ledger::audits() const {
  return guarded(connection_->file, [&] {
    std::vector<Audit> audits;
    if (!connection_->database.tableExists("audits")) return audits;
    SQLite::Statement rows(connection_->database,
                           "SELECT condition, pair, leg, attempt, verdict, hash, reason FROM audits "
                           "ORDER BY condition, pair, leg, attempt");
    while (rows.executeStep()) {
      Audit audit;
      audit.key = {rows.getColumn(0).getString(), rows.getColumn(1).getInt(), rows.getColumn(2).getInt()};
      audit.attempt = rows.getColumn(3).getInt();
      try {
        audit.verdict = verdict_from_name(rows.getColumn(4).getString());
      } catch (const std::invalid_argument& error) {
        throw StorageError(connection_->file + ": the audit of game " + game_id(audit.key) +
                           " cannot be read: " + error.what());
      }
      audit.hash = rows.getColumn(5).getString();
      audit.reason = rows.getColumn(6).getString();
      audits.push_back(std::move(audit));
    }
    return audits;
  });
}

Experiment Ledger::experiment() const {
  return guarded(connection_->file, [&] {
    Experiment experiment;
    SQLite::Statement rows(connection_->database, "SELECT key, value FROM experiment");
    while (rows.executeStep()) {
      const std::string key = rows.getColumn(0).getString();
      if (key == "hash") experiment.hash = rows.getColumn(1).getString();
      if (key == "design") experiment.design = rows.getColumn(1).getString();
    }
    return experiment;
  });
}

}  // namespace record
