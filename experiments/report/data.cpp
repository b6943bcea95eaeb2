// The formats for programs: every number in full.
#include <array>
#include <utility>

#include "experiments/record/json_text.h"
#include "experiments/report/formats.h"

namespace report {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;  // name and JSON value

void add_mean(Fields& fields, const std::string& name, const stats::Mean& mean) {
  fields.emplace_back(name, mean.count > 0 ? record::number(mean.mean) : "null");
  fields.emplace_back(name + "_standard_error",
                      mean.has_error() ? record::number(mean.standard_error) : "null");
}

void add_side(Fields& fields, const std::string& letter, const Side& side, const record::TeamConfig& team) {
  fields.emplace_back(letter + "_name", record::quoted(team.name));
  fields.emplace_back(letter + "_robots", std::to_string(team.robots.size()));
  fields.emplace_back(letter + "_speed_factor", record::number(team.speed_factor));
  fields.emplace_back(letter + "_wins", std::to_string(side.wins));
  fields.emplace_back(letter + "_win_share_low", record::number(side.win_share.low));
  fields.emplace_back(letter + "_win_share_high", record::number(side.win_share.high));
  add_mean(fields, letter + "_goals", side.goals);
  fields.emplace_back(letter + "_fouls", record::number(side.fouls));
  fields.emplace_back(letter + "_forfeits", std::to_string(side.forfeits));
}

Fields fields_of(const Row& row, const Header::Condition& condition) {
  Fields fields;
  fields.emplace_back("condition", record::quoted(row.condition));
  fields.emplace_back("realism", record::quoted(condition.realism));
  fields.emplace_back("games", std::to_string(row.games));
  fields.emplace_back("draws", std::to_string(row.draws));
  add_side(fields, "a", row.a, condition.a);
  add_side(fields, "b", row.b, condition.b);
  add_mean(fields, "goal_difference", row.difference);
  fields.emplace_back("pairs", std::to_string(row.difference.count));
  fields.emplace_back("sign_test_p", record::number(row.p));
  fields.emplace_back("stoppages", record::number(row.stoppages));
  fields.emplace_back("void_attempts", std::to_string(row.void_attempts));
  fields.emplace_back("given_up_pairs", std::to_string(row.given_up_pairs));
  fields.emplace_back("verdict", record::quoted(row.verdict()));
  return fields;
}

std::string json_object(const Fields& fields, const std::string& indent) {
  std::string text = "{";
  for (const auto& [name, value] : fields) {
    text += (text.size() > 1 ? ",\n" : "\n") + indent + "  " + record::quoted(name) + ": " + value;
  }
  return text + "\n" + indent + "}";
}

std::string json_rows(const Header& header, const std::vector<Row>& rows) {
  std::string text = "[";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += (i > 0 ? ", " : "") + json_object(fields_of(rows[i], header.conditions[i]), "    ");
  }
  return text + "]";
}

/// A JSON value as a cell: texts with their quotes doubled inside, null as an empty cell.
std::string csv_cell(const std::string& json) {
  if (json == "null") return "";
  if (json.empty() || json.front() != '"') return json;
  std::string text = "\"";
  for (std::size_t i = 1; i + 1 < json.size(); ++i) {
    if (json[i] == '\\' && i + 2 < json.size()) {
      ++i;
      if (json[i] == '"') text += '"';
    }
    text += json[i];
  }
  return text + "\"";
}

}  // namespace

std::string as_json(const Summary& summary) {
  const Header& header = summary.header;
  return json_object({{"design", record::quoted(header.design)},
                      {"description", record::quoted(header.description)},
                      {"rules", record::quoted(header.rules)},
                      {"half_length", header.half_length ? record::number(*header.half_length) : "null"},
                      {"realism", record::quoted(header.realism)},
                      {"seed", std::to_string(header.seed)},
                      {"pairs", std::to_string(header.pairs)},
                      {"forfeit_goals", std::to_string(header.forfeit_goals)},
                      {"experiment", record::quoted(header.experiment)},
                      {"games", std::to_string(summary.games)},
                      {"planned", std::to_string(summary.planned)},
                      {"repeated_games", std::to_string(summary.repeated_games)},
                      {"conditions", json_rows(header, summary.rows)},
                      {"conditions_without_forfeits", json_rows(header, summary.without_forfeits)}},
                     "") +
         "\n";
}

std::string as_csv(const Summary& summary) {
  std::string text;
  const auto line = [&text](const std::string& forfeits, const Fields& fields, bool names) {
    text += forfeits;
    for (const auto& [name, value] : fields) text += "," + (names ? name : csv_cell(value));
    text += "\n";
  };
  for (std::size_t i = 0; i < summary.rows.size(); ++i) {
    const Fields fields = fields_of(summary.rows[i], summary.header.conditions[i]);
    if (i == 0) line("forfeits", fields, true);
    line("counted", fields, false);
  }
  for (std::size_t i = 0; i < summary.without_forfeits.size(); ++i) {
    line("left out", fields_of(summary.without_forfeits[i], summary.header.conditions[i]), false);
  }
  return text;
}

}  // namespace report
