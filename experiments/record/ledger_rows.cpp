#include "experiments/record/ledger_rows.h"

#include <charconv>
#include <limits>
#include <stdexcept>

#include "experiments/record/ledger_tables.h"

namespace record {
namespace {

constexpr std::int64_t most_pairs = 100'000'000;  // ours: four centuries of games
constexpr std::int64_t most_workers = 1'000'000;

[[noreturn]] void wrong(const char* column, const std::string& value, const std::string& right) {
  constexpr std::size_t shown = 60;
  throw std::invalid_argument("column " + std::string(column) + " must be " + right + ", not '" +
                              value.substr(0, shown) + "'");
}

std::string text_of(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* real = std::get_if<double>(&value)) return std::to_string(*real);
  return "NULL";
}

const std::string& text(const Value& value, const char* column) {
  const auto* found = std::get_if<std::string>(&value);
  if (found == nullptr) wrong(column, text_of(value), "a text");
  return *found;
}

std::int64_t whole(const Value& value, const char* column, std::int64_t least, std::int64_t most) {
  const auto* found = std::get_if<std::int64_t>(&value);
  if (found == nullptr || *found < least || *found > most) {
    wrong(column, text_of(value),
          "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return *found;
}

template <class Number>
Number decimal(const std::string& text, const char* column) {
  Number value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) {
    wrong(column, text, "a whole number up to " + std::to_string(std::numeric_limits<Number>::max()));
  }
  return value;
}

world::Team colour(const Value& value, const char* column) {
  const std::string& word = text(value, column);
  for (const world::Team team : world::both_teams) {
    if (word == world::name(team)) return team;
  }
  wrong(column, word, "yellow or blue");
}

GameKey key_of(const Row& row, std::size_t first) {
  return {text(row[first], "condition"), static_cast<int>(whole(row[first + 1], "pair", 0, most_pairs)),
          static_cast<int>(whole(row[first + 2], "leg", 0, 1))};
}

int attempt_number(const Value& value) { return static_cast<int>(whole(value, "attempt", 1, max_attempts)); }

/// A column that repeats a number of the record.
void same(const Value& value, const char* column, std::int64_t expected) {
  if (const auto* found = std::get_if<std::int64_t>(&value); found != nullptr && *found == expected) return;
  wrong(column, text_of(value), std::to_string(expected) + " as in the record");
}

std::string digest(const char* table, const Row& row) {
  RowChecksum checksum(table);
  for (const Value& value : row) checksum.add(value);
  return checksum.digits();
}

Value value_of(const SQLite::Column& column) {
  if (column.isNull()) return std::monostate{};
  if (column.isInteger()) return column.getInt64();
  if (column.isFloat()) return column.getDouble();
  return column.getString();
}

std::string digest(const Pairs& pairs) {
  RowChecksum checksum("experiment");
  for (const auto& [key, value] : pairs) {
    if (key == checksum_key) continue;
    checksum.add(key);
    checksum.add(value);
  }
  return checksum.digits();
}

}  // namespace

Row row_of(const Attempt& attempt) {
  const MatchRecord& record = attempt.record;
  const auto integer = [](auto number) { return static_cast<std::int64_t>(number); };
  return {game_id(attempt.key),
          attempt.key.condition,
          integer(attempt.key.pair),
          integer(attempt.key.leg),
          integer(attempt.attempt),
          std::to_string(attempt.seed),
          world::name(attempt.a_colour),
          integer(attempt.blue_on_positive_half ? 1 : 0),
          world::name(attempt.first_kickoff),
          name(outcome(record)),
          name(record.termination),
          name(record.at_fault),
          record.reason,
          integer(record.goals.yellow),
          integer(record.goals.blue),
          integer(record.ticks),
          record.hash,
          integer(record.fouls.yellow),
          integer(record.fouls.blue),
          integer(record.stoppages),
          record.wall_seconds,
          integer(attempt.worker),
          attempt.started,
          to_json(record)};
}

Row row_of(const Audit& audit) {
  return {audit.key.condition,
          std::int64_t{audit.key.pair},
          std::int64_t{audit.key.leg},
          std::int64_t{audit.attempt},
          name(audit.verdict),
          audit.hash,
          audit.reason};
}

Row row_of(const KeptFile& file) { return {file.path, file.size, file.checksum}; }

void write_row(SQLite::Database& database, const char* verb, const char* table, const Row& row) {
  std::string marks = "?";
  for (std::size_t i = 0; i < row.size(); ++i) marks += ",?";
  SQLite::Statement insert(database, std::string(verb) + " INTO " + table + " VALUES (" + marks + ")");
  int column = 0;
  for (const Value& value : row) {
    ++column;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
      insert.bind(column, *integer);
    } else if (const auto* real = std::get_if<double>(&value)) {
      insert.bind(column, *real);
    } else {
      insert.bind(column, std::get<std::string>(value));
    }
  }
  insert.bind(++column, digest(table, row));
  insert.exec();
}

RowReader::RowReader(SQLite::Database& database, const char* table, const char* order)
    : table_(table),
      signed_(database
                  .execAndGet("SELECT count(*) FROM pragma_table_info('" + std::string(table) +
                              "') WHERE name = 'checksum'")
                  .getInt() > 0),
      statement_(database, std::string("SELECT * FROM ") + table + " ORDER BY " + order) {}

bool RowReader::next() {
  if (!statement_.executeStep()) return false;
  const int columns = statement_.getColumnCount() - (signed_ ? 1 : 0);
  row_.resize(static_cast<std::size_t>(columns));
  for (int i = 0; i < columns; ++i) row_[static_cast<std::size_t>(i)] = value_of(statement_.getColumn(i));
  state_ = RowState::Unknown;
  if (signed_ && !statement_.isColumnNull(columns)) {
    const bool right = statement_.getColumn(columns).getString() == digest(table_, row_);
    state_ = right ? RowState::Whole : RowState::Damaged;
  }
  return true;
}

std::string place_of(const Row& row, const char* table) {
  const std::string kind = table;
  if (kind == "files") return "the row of file " + text_of(row[0]);
  const std::size_t first = kind == "attempts" ? 1 : 0;
  const auto* pair = std::get_if<std::int64_t>(&row[first + 1]);
  const auto* leg = std::get_if<std::int64_t>(&row[first + 2]);
  std::string game = text_of(row[first]) + "-" + text_of(row[first + 1]) + "-" + text_of(row[first + 2]);
  if (pair != nullptr && leg != nullptr && *pair >= 0 && *pair <= most_pairs && *leg >= 0 && *leg <= 1) {
    game = game_id({text_of(row[first]), static_cast<int>(*pair), static_cast<int>(*leg)});
  }
  return (kind == "audits" ? "the audit of game " : "game ") + game + ", attempt " + text_of(row[first + 3]);
}

Attempt attempt_of(const Row& row, Detail detail) {
  Attempt attempt;
  attempt.key = key_of(row, 1);
  attempt.attempt = attempt_number(row[4]);
  attempt.seed = decimal<std::uint64_t>(text(row[5], "seed"), "seed");
  attempt.a_colour = colour(row[6], "a_colour");
  attempt.blue_on_positive_half = whole(row[7], "blue_on_positive_half", 0, 1) == 1;
  attempt.first_kickoff = colour(row[8], "first_kickoff");
  attempt.worker = static_cast<int>(whole(row[21], "worker", 0, most_workers));
  attempt.started = text(row[22], "started");
  attempt.record = match_record_from_json(text(row[23], "record"),
                                          detail == Detail::Whole ? Timeline::Read : Timeline::Skip);
  same(row[13], "goals_yellow", attempt.record.goals.yellow);
  same(row[14], "goals_blue", attempt.record.goals.blue);
  same(row[15], "ticks", attempt.record.ticks);
  return attempt;
}

Audit audit_of(const Row& row) {
  Audit audit;
  audit.key = key_of(row, 0);
  audit.attempt = attempt_number(row[3]);
  audit.verdict = verdict_from_name(text(row[4], "verdict"));
  audit.hash = text(row[5], "hash");
  audit.reason = text(row[6], "reason");
  return audit;
}

KeptFile file_of(const Row& row) {
  return {text(row[0], "path"), whole(row[1], "size", 0, std::numeric_limits<std::int64_t>::max()),
          text(row[2], "contents")};
}

Pairs read_experiment(SQLite::Database& database) {
  Pairs pairs;
  SQLite::Statement rows(database, "SELECT key, value FROM experiment");
  while (rows.executeStep()) pairs[rows.getColumn(0).getString()] = rows.getColumn(1).getString();
  return pairs;
}

void write_experiment(SQLite::Database& database, Pairs pairs) {
  pairs[checksum_key] = digest(pairs);
  SQLite::Statement insert(database, "INSERT OR REPLACE INTO experiment VALUES (?, ?)");
  for (const auto& [key, value] : pairs) {
    insert.bind(1, key);
    insert.bind(2, value);
    insert.exec();
    insert.reset();
  }
}

std::string problem_of_hash(const Pairs& pairs) {
  const auto found = pairs.find(hash_key);
  const std::string hash = found == pairs.end() ? "" : found->second;
  constexpr std::size_t digits = 32;
  if (hash.size() == digits && hash.find_first_not_of("0123456789abcdef") == std::string::npos) return {};
  constexpr std::size_t shown = 60;
  return "the experiment's hash must be 32 hexadecimal digits, not '" + hash.substr(0, shown) + "'";
}

RowState state_of(const Pairs& pairs, int version) {
  if (version < 4 && (pairs.contains(audits_key) || pairs.contains(files_key))) return RowState::Damaged;
  if (version < 3) return pairs.contains(checksum_key) ? RowState::Damaged : RowState::Unknown;
  const auto found = pairs.find(checksum_key);
  return found != pairs.end() && found->second == digest(pairs) ? RowState::Whole : RowState::Damaged;
}

std::int64_t number_in(const Pairs& pairs, const char* key) {
  const auto found = pairs.find(key);
  return found == pairs.end() ? 0 : decimal<std::int64_t>(found->second, key);
}

}  // namespace record
