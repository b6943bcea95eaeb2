// The formats for programs: every number in full.
#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "experiments/record/json_text.h"
#include "experiments/report/formats.h"
#include "experiments/report/health.h"
#include "experiments/report/wording.h"
#include "sim/console/printable.h"

namespace report {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;  // name and JSON value

void add_mean(Fields& fields, const std::string& name, const stats::Mean& mean) {
  fields.emplace_back(name, mean.count > 0 ? record::number(mean.mean) : "null");
  fields.emplace_back(name + "_standard_error",
                      mean.has_error() ? record::number(mean.standard_error) : "null");
}

/// Infinite ends become null.
void add_interval(Fields& fields, const std::string& name, const stats::Interval& interval) {
  fields.emplace_back(name + "_low", record::number(interval.low));
  fields.emplace_back(name + "_high", record::number(interval.high));
}

std::string optional_number(const std::optional<double>& value) {
  return value ? record::number(*value) : "null";
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
  add_interval(fields, "goal_difference_t", row.t_test.interval);
  fields.emplace_back("goal_difference_t_p", row.t_test.known ? record::number(row.t_test.p) : "null");
  add_interval(fields, "goal_difference_bootstrap", row.bootstrap);
  fields.emplace_back("sign_flip_p", record::number(row.permutation_p));
  fields.emplace_back("sign_flip_p_holm", optional_number(row.permutation_p_holm));
  fields.emplace_back("pair_correlation",
                      row.correlation.known ? record::number(row.correlation.value) : "null");
  fields.emplace_back("pair_correlation_standard_error",
                      row.correlation.known ? record::number(row.correlation.standard_error) : "null");
  fields.emplace_back("pairs", std::to_string(row.difference.count));
  fields.emplace_back("sign_test_p", record::number(row.p));
  fields.emplace_back("sign_test_p_holm", optional_number(row.p_holm));
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

/// A list of objects, or of any other JSON.
template <class Items, class Write>
std::string json_list(const Items& items, Write write) {
  std::string text = "[";
  for (const auto& item : items) text += (text.size() > 1 ? ", " : "") + write(item);
  return text + "]";
}

std::string statistics_json(const std::vector<Comparison>& comparisons) {
  return json_list(comparisons, [](const Comparison& one) {
    Fields fields;
    fields.emplace_back("name", record::quoted(one.name));
    add_mean(fields, "a", one.a);
    add_mean(fields, "b", one.b);
    fields.emplace_back("difference", record::number(one.test.difference));
    add_interval(fields, "difference", one.test.interval);
    fields.emplace_back("p", one.test.known ? record::number(one.test.p) : "null");
    fields.emplace_back("p_holm", one.test.known ? record::number(one.p_holm) : "null");
    return json_object(fields, "      ");
  });
}

std::string game_numbers_json(const std::vector<GameNumber>& numbers) {
  return json_list(numbers, [](const GameNumber& one) {
    Fields fields;
    fields.emplace_back("name", record::quoted(one.name));
    add_mean(fields, "value", one.value);
    return json_object(fields, "      ");
  });
}

std::string values_json(const std::map<std::string, double>& values) {
  Fields fields;
  for (const auto& [key, value] : values) fields.emplace_back(key, record::number(value));
  return fields.empty() ? "{}" : json_object(fields, "      ");
}

std::string json_rows(const Header& header, const std::vector<Row>& rows) {
  std::string text = "[";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    Fields fields = fields_of(rows[i], header.conditions[i]);
    fields.emplace_back(
        "sweep", header.conditions[i].sweep.empty() ? "null" : record::quoted(header.conditions[i].sweep));
    fields.emplace_back("values", values_json(header.conditions[i].values));
    fields.emplace_back("statistics", statistics_json(rows[i].comparisons));
    fields.emplace_back("game_statistics", game_numbers_json(rows[i].game_numbers));
    text += (i > 0 ? ", " : "") + json_object(fields, "    ");
  }
  return text + "]";
}

std::string json_sweeps(const std::vector<Sweep>& sweeps) {
  return json_list(sweeps, [](const Sweep& sweep) {
    Fields fields;
    fields.emplace_back("sweep", record::quoted(sweep.name));
    fields.emplace_back("key", record::quoted(sweep.key));
    fields.emplace_back("slope", sweep.trend.known ? record::number(sweep.trend.slope) : "null");
    const auto if_known = [&](const std::string& name, double value) {
      fields.emplace_back(name, sweep.trend.known ? record::number(value) : "null");
    };
    if_known("slope_standard_error", sweep.trend.standard_error);
    if_known("slope_low", sweep.trend.interval.low);
    if_known("slope_high", sweep.trend.interval.high);
    if_known("p", sweep.trend.p);
    if_known("permutation_p", sweep.trend.permutation_p);
    return json_object(fields, "    ");
  });
}

std::string json_panels(const std::vector<PanelComparison>& panels) {
  return json_list(panels, [](const PanelComparison& panel) {
    Fields fields;
    fields.emplace_back("panel", record::quoted(panel.base));
    fields.emplace_back("verdict", record::quoted(panel.sentence()));
    fields.emplace_back("opponents", json_list(panel.lines, [](const PanelComparison::Line& line) {
                          Fields inner;
                          inner.emplace_back("opponent", record::quoted(line.opponent));
                          inner.emplace_back("pairs", std::to_string(line.pairs));
                          add_mean(inner, "a", line.a);
                          add_mean(inner, "b", line.b);
                          inner.emplace_back("difference", record::number(line.test.difference));
                          add_interval(inner, "difference", line.test.interval);
                          inner.emplace_back("p", line.test.known ? record::number(line.test.p) : "null");
                          inner.emplace_back("win_share_difference", record::number(line.win_share));
                          add_interval(inner, "win_share_difference", line.win_share_interval);
                          return json_object(inner, "      ");
                        }));
    return json_object(fields, "    ");
  });
}

std::string json_audits(const std::vector<record::Audit>& audits) {
  Fields fields = {{"audited", std::to_string(audits.size())}};
  for (const AuditLine& line : audit_lines(audits))
    fields.emplace_back(record::name(line.verdict), std::to_string(line.count));
  return json_object(fields, "  ");
}

/// A panel's comparisons in the columns of a condition's row: A's goal difference minus B's.
std::vector<Fields> panel_fields(const PanelComparison& panel) {
  std::vector<Fields> all;
  for (const PanelComparison::Line& line : panel.lines) {
    Fields fields;
    fields.emplace_back("condition", record::quoted(panel.base + ": A minus B against " + line.opponent));
    fields.emplace_back("a_name", record::quoted(panel.a));
    fields.emplace_back("b_name", record::quoted(panel.b));
    fields.emplace_back("goal_difference", record::number(line.test.difference));
    fields.emplace_back("goal_difference_standard_error",
                        line.pairs > 1 ? record::number(line.test.standard_error) : "null");
    add_interval(fields, "goal_difference_t", line.test.interval);
    fields.emplace_back("goal_difference_t_p", line.test.known ? record::number(line.test.p) : "null");
    fields.emplace_back("pairs", std::to_string(line.pairs));
    fields.emplace_back("verdict", record::quoted(panel.sentence()));
    all.push_back(std::move(fields));
  }
  return all;
}

/// The same columns as `columns`, empty where there is nothing of that name.
Fields in_columns_of(const Fields& columns, const Fields& fields) {
  Fields result;
  for (const auto& [name, ignored] : columns) {
    const auto found =
        std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.first == name; });
    result.emplace_back(name, found == fields.end() ? "null" : found->second);
  }
  return result;
}

std::string json_texts(const std::vector<std::string>& texts) {
  return json_list(texts, [](const std::string& text) { return record::quoted(text); });
}

/// What a line of a spreadsheet has beside the fields of its row: values of sweeps and statistics, the same
/// columns in every line.
class Extras {
 public:
  explicit Extras(const Summary& summary) {
    for (const Header::Condition& condition : summary.header.conditions) {
      for (const auto& [key, value] : condition.values) values_.insert(key);
    }
    for (const auto* rows : {&summary.rows, &summary.without_forfeits}) {
      for (const Row& row : *rows) {
        for (const Comparison& one : row.comparisons) statistics_.insert(one.name);
        for (const GameNumber& one : row.game_numbers) numbers_.insert(one.name);
      }
    }
  }

  void add(Fields& fields, const Row& row, const Header::Condition& condition) const {
    for (const std::string& key : values_) {
      const auto found = condition.values.find(key);
      fields.emplace_back("value_" + key,
                          found == condition.values.end() ? "null" : record::number(found->second));
    }
    for (const std::string& name : numbers_) {
      const auto found = std::find_if(row.game_numbers.begin(), row.game_numbers.end(),
                                      [&](const GameNumber& one) { return one.name == name; });
      add_mean(fields, name, found == row.game_numbers.end() ? stats::Mean{} : found->value);
    }
    for (const std::string& name : statistics_) {
      const auto found = std::find_if(row.comparisons.begin(), row.comparisons.end(),
                                      [&](const Comparison& one) { return one.name == name; });
      const bool there = found != row.comparisons.end();
      add_mean(fields, name + "_a", there ? found->a : stats::Mean{});
      add_mean(fields, name + "_b", there ? found->b : stats::Mean{});
      fields.emplace_back(name + "_difference", there ? record::number(found->test.difference) : "null");
      const bool tested = there && found->test.known;
      fields.emplace_back(name + "_p", tested ? record::number(found->test.p) : "null");
      fields.emplace_back(name + "_p_holm", tested ? record::number(found->p_holm) : "null");
    }
  }

 private:
  std::set<std::string> values_;
  std::set<std::string> numbers_;
  std::set<std::string> statistics_;
};

/// The text of a JSON string as record::quoted() writes it: \u is a control character there.
std::string unquoted(const std::string& json) {
  std::string text;
  for (std::size_t i = 1; i + 1 < json.size(); ++i) {
    if (json[i] != '\\') {
      text += json[i];
      continue;
    }
    ++i;
    constexpr std::size_t digits = 4;
    if (json[i] == 'u') {
      text += '\x1A';
      i += digits;
    } else {
      text += std::string_view("bfnrt").find(json[i]) != std::string_view::npos ? ' ' : json[i];
    }
  }
  return text;
}

/// A JSON value as a cell: texts with their quotes doubled inside, null as an empty cell. A text that a
/// spreadsheet would take for a formula begins with an apostrophe.
std::string csv_cell(const std::string& value) {
  if (value == "null") return "";
  if (value.empty() || value.front() != '"') return value;
  const std::string words = console::printable(unquoted(value));
  std::string text = "\"";
  if (!words.empty() && std::string_view("=+-@").find(words.front()) != std::string_view::npos) text += '\'';
  for (const char letter : words) text += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return text + "\"";
}

/// The name of a column; those of sweeps have keys of the design in them.
std::string csv_name(const std::string& name) {
  const bool plain =
      name.find_first_of(",;\"'\n\r\t") == std::string::npos && console::printable(name) == name;
  return plain ? name : csv_cell(record::quoted(name));
}

}  // namespace

std::string as_json(const Summary& summary) {
  const Header& header = summary.header;
  return console::printable_json(
             json_object({{"design", record::quoted(header.design)},
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
                          {"stopping", record::quoted(header.stopping)},
                          {"answers", json_texts(header.answers)},
                          {"warnings", json_texts(warnings(summary))},
                          {"audits", json_audits(header.audits)},
                          {"panels", json_panels(summary.panels)},
                          {"sweeps", json_sweeps(summary.sweeps)},
                          {"conditions", json_rows(header, summary.rows)},
                          {"conditions_without_forfeits", json_rows(header, summary.without_forfeits)}},
                         "")) +
         "\n";
}

std::string as_csv(const Summary& summary) {
  std::string text;
  const auto line = [&text](const std::string& forfeits, const Fields& fields, bool names) {
    text += forfeits;
    for (const auto& [name, value] : fields) text += "," + (names ? csv_name(name) : csv_cell(value));
    text += "\n";
  };
  const Extras extras(summary);
  const auto fields_with_extras = [&](const Row& row, std::size_t i) {
    Fields fields = fields_of(row, summary.header.conditions[i]);
    extras.add(fields, row, summary.header.conditions[i]);
    return fields;
  };
  for (std::size_t i = 0; i < summary.rows.size(); ++i) {
    const Fields fields = fields_with_extras(summary.rows[i], i);
    if (i == 0) line("forfeits", fields, true);
    line("counted", fields, false);
  }
  for (std::size_t i = 0; i < summary.without_forfeits.size(); ++i) {
    line("left out", fields_with_extras(summary.without_forfeits[i], i), false);
  }
  if (summary.rows.empty()) return text;
  const Fields columns = fields_with_extras(summary.rows.front(), 0);
  for (const PanelComparison& panel : summary.panels) {
    for (const Fields& fields : panel_fields(panel)) line("panel", in_columns_of(columns, fields), false);
  }
  return text;
}

}  // namespace report
