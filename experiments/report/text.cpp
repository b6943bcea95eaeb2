#include <fmt/format.h>

#include <stdexcept>

#include "experiments/report/formats.h"
#include "experiments/report/wording.h"

namespace report {
namespace {

constexpr std::size_t team_width = 33;  // with it a line has 107 columns

std::string shortened(const std::string& text, std::size_t width) {
  return text.size() <= width ? text : fmt::format("{}~", text.substr(0, width - 1));
}

std::string side_line(const std::string& team, const Row& row, const Side& side, const Side& other) {
  return fmt::format("  {:<{}} {:>5} {:>5} {:>5} {:>5}   {:<20} {:<13} {:>6}\n", shortened(team, team_width),
                     team_width, row.games, side.wins, row.draws, other.wins, percent(side, row.games),
                     plus_minus(side.goals), one_decimal(side.fouls));
}

std::string table(const Header& header, const std::vector<Row>& rows) {
  std::string text =
      fmt::format("  {:<{}} {:>5} {:>5} {:>5} {:>5}   {:<20} {:<13} {:>6}\n", "team", team_width, "games",
                  "wins", "draws", "lost", "win % [95 %]", "goals a game", "fouls");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    const std::string& realism = header.conditions[i].realism;
    const std::string other_realism = realism == header.realism ? "" : " (realism " + realism + ")";
    text += "\n" + row.condition + other_realism + ": " + row.verdict() + "\n";
    text += side_line(described('A', header.conditions[i].a), row, row.a, row.b);
    text += side_line(described('B', header.conditions[i].b), row, row.b, row.a);
    text += fmt::format("  A - B {} goals a game over {} pair{}, {} stoppages a game\n",
                        signed_plus_minus(row.difference), row.difference.count,
                        row.difference.count == 1 ? "" : "s", one_decimal(row.stoppages));
  }
  return text;
}

}  // namespace

std::string as_text(const Summary& summary) {
  const Header& header = summary.header;
  std::string text = header.design + (header.description.empty() ? "" : ": " + header.description) + "\n";
  text += circumstances(summary) + "\n\n";
  if (!summary.without_forfeits.empty()) {
    text += fmt::format("Forfeits counted as lost 0:{}\n\n", header.forfeit_goals);
  }
  text += table(header, summary.rows);
  if (!summary.without_forfeits.empty()) {
    text += "\nThe pairs without forfeits alone\n\n" + table(header, summary.without_forfeits);
  }
  text +=
      "\n± is one standard error; fouls are calls against the team per game;\np is the exact two-sided sign "
      "test of A's wins against its losses.\n";
  for (const std::string& warning : warnings(summary)) text += "Note: " + warning + ".\n";
  return text;
}

std::string formatted(const Summary& summary, std::string_view format) {
  if (format == "text") return as_text(summary);
  if (format == "markdown") return as_markdown(summary);
  if (format == "csv") return as_csv(summary);
  if (format == "json") return as_json(summary);
  throw std::invalid_argument("unknown format '" + std::string(format) +
                              "'; known are: text, markdown, csv, json");
}

}  // namespace report
