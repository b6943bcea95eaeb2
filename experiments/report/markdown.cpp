#include <fmt/format.h>

#include "experiments/report/formats.h"
#include "experiments/report/wording.h"

namespace report {
namespace {

/// A text as a cell: a bar would end it.
std::string cell(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '|') result += '\\';
    result += letter;
  }
  return result;
}

std::string table(const Header& header, const std::vector<Row>& rows) {
  std::string text =
      "| condition | A | B | games | A wins | draws | B wins | A win % [95 %] | B win % [95 %] | A goals | B "
      "goals "
      "| A - B | fouls A / B | stoppages | verdict |\n"
      "|---|---|---|---:|---:|---:|---:|---|---|---|---|---|---|---:|---|\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    text +=
        fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} / {} | {} | {} |\n",
                    cell(header.conditions[i].realism == header.realism
                             ? row.condition
                             : row.condition + ", realism " + header.conditions[i].realism),
                    cell(described('A', header.conditions[i].a).substr(2)),
                    cell(described('B', header.conditions[i].b).substr(2)), row.games, row.a.wins, row.draws,
                    row.b.wins, percent(row.a, row.games), percent(row.b, row.games), plus_minus(row.a.goals),
                    plus_minus(row.b.goals), signed_plus_minus(row.difference), one_decimal(row.a.fouls),
                    one_decimal(row.b.fouls), one_decimal(row.stoppages), row.verdict());
  }
  return text;
}

}  // namespace

std::string as_markdown(const Summary& summary) {
  const Header& header = summary.header;
  std::string text = "## " + header.design + "\n\n";
  if (!header.description.empty()) text += header.description + "\n\n";
  text += circumstances(summary) + "\n\n" + table(header, summary.rows);
  if (!summary.without_forfeits.empty()) {
    text += fmt::format("\nForfeits counted above as lost 0:{}. The pairs without forfeits alone:\n\n",
                        header.forfeit_goals) +
            table(header, summary.without_forfeits);
  }
  text +=
      "\n± is one standard error; fouls are calls against the team per game;\np is the exact two-sided sign "
      "test of A's wins against its losses.\n";
  for (const std::string& warning : warnings(summary)) text += "\nNote: " + warning + ".\n";
  return text;
}

}  // namespace report
