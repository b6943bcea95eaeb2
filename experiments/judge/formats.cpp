#include <fmt/format.h>

#include "experiments/judge/failures.h"
#include "experiments/judge/tables.h"
#include "experiments/record/json_text.h"

namespace judge {
namespace {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + "\"";
}

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t n = 0; n < fields.size(); ++n) line += (n > 0 ? "," : "") + csv_field(fields[n]);
  return line + "\n";
}

std::string markdown_line(const std::vector<std::string>& fields) {
  std::string line = "|";
  for (const std::string& field : fields) line += " " + field + " |";
  return line + "\n";
}

std::string json_list(const std::vector<std::string>& fields) {
  std::string list = "[";
  for (std::size_t n = 0; n < fields.size(); ++n) list += (n > 0 ? ", " : "") + record::quoted(fields[n]);
  return list + "]";
}

}  // namespace

std::string as_markdown(std::span<const Table> tables) {
  std::string text;
  for (const Table& table : tables) {
    text += fmt::format("## {}\n\n{}\n\n", table.title, table.note);
    text += markdown_line(table.columns);
    text += markdown_line(std::vector<std::string>(table.columns.size(), "---"));
    for (const auto& row : table.rows) text += markdown_line(row);
    text += "\n";
    if (!table.command.empty()) text += fmt::format("Made by `{}`\n\n", table.command);
  }
  return text;
}

std::string as_csv(const Table& table) {
  std::string text = table.command.empty() ? "" : "# made by " + table.command + "\n";
  text += csv_line(table.columns);
  for (const auto& row : table.rows) text += csv_line(row);
  return text;
}

std::string as_json(std::span<const Table> tables) {
  std::string text = "{";
  for (std::size_t n = 0; n < tables.size(); ++n) {
    const Table& table = tables[n];
    text +=
        fmt::format("{}\n  {}: {{\"title\": {}, \"command\": {}, \"note\": {}, \"columns\": {}, \"rows\": [",
                    n > 0 ? "," : "", record::quoted(table.name), record::quoted(table.title),
                    record::quoted(table.command), record::quoted(table.note), json_list(table.columns));
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      text += (r > 0 ? ",\n    " : "\n    ") + json_list(table.rows[r]);
    }
    text += "]}";
  }
  return text + "\n}\n";
}

std::string as_csv(std::span<const Failure> failures) {
  std::string text =
      csv_line({"game", "referee", "event", "first tick", "last tick", "what truth and call say"});
  for (const Failure& one : failures) {
    text += csv_line({one.game, one.shadow, one.event, std::to_string(one.first_tick),
                      std::to_string(one.last_tick), one.what});
  }
  return text;
}

}  // namespace judge
