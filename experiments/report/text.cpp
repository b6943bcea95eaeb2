#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "experiments/report/formats.h"
#include "experiments/report/wording.h"
#include "sim/console/printable.h"

namespace report {
namespace {

constexpr std::size_t team_width = 30;  // with it a line has 100 columns
constexpr std::size_t line_width = 100;
constexpr std::size_t most_compared = 4;  // conditions whose match statistics a terminal shows

std::size_t columns(const std::string& text) { return console::length(text); }

/// The text at most so wide, cut between characters.
std::string shortened(const std::string& text, std::size_t width) {
  return columns(text) <= width ? text : console::shortened(console::printable(text), width);
}

std::string left(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, columns(text)), ' ');
}

std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, columns(text)), ' ') + text;
}

/// Broken between words; lines after the first are indented by `indent`, the first as it is.
std::string wrapped(const std::string& text, const std::string& indent) {
  std::string result;
  std::string line = text.substr(0, text.find_first_not_of(' '));
  bool first_word = true;
  std::istringstream words(text);
  for (std::string word; words >> word; first_word = false) {
    if (!first_word && columns(line) + 1 + columns(word) > line_width) {
      result += line + "\n";
      line = indent + word;
    } else {
      line += (first_word ? "" : " ") + word;
    }
  }
  return result + line + "\n";
}

std::string side_line(const std::string& team, const Row& row, const Side& side, const Side& other) {
  return fmt::format("  {} {:>5} {:>5} {:>5} {:>5}   {:<20} {} {:>6}\n",
                     left(shortened(team, team_width), team_width), row.games, side.wins, row.draws,
                     other.wins, percent(side, row.games), left(plus_minus(side.goals), 13),
                     one_decimal(side.fouls));
}

std::string difference_lines(const Row& row) {
  if (row.difference.count == 0) return "";
  return fmt::format("  A - B {} goals a game, 95 %: t {}, bootstrap {}\n", signed_plus_minus(row.difference),
                     bracketed(row.t_test.interval), bracketed(row.bootstrap)) +
         wrapped(fmt::format("        sign flips p {}; {} pair{}, r within pairs {}; {} stoppages a game",
                             p_value(row.permutation_p, row.permutation_p_holm), row.difference.count,
                             row.difference.count == 1 ? "" : "s", correlation(row.correlation),
                             one_decimal(row.stoppages)),
                 "        ");
}

std::string table(const Header& header, const std::vector<Row>& rows) {
  std::string text =
      fmt::format("  {:<{}} {:>5} {:>5} {:>5} {:>5}   {:<20} {:<13} {:>6}\n", "team", team_width, "games",
                  "wins", "draws", "lost", "win % [95 %]", "goals a game", "fouls");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    text += "\n" + wrapped(titled(header, i) + ": " + row.verdict(), "  ");
    text += side_line(described('A', header.conditions[i].a), row, row.a, row.b);
    text += side_line(described('B', header.conditions[i].b), row, row.b, row.a);
    text += difference_lines(row);
  }
  return text;
}

std::string statistics(const Row& row) {
  std::string text =
      fmt::format("\n  {:<28} {:>14} {:>14} {:>10}  {:<17} {}\n",
                  shortened("statistics, " + row.condition, 28), "A", "B", "A - B", "95 %", "Holm p");
  for (const Comparison& one : row.comparisons) {
    text +=
        fmt::format("  {} {} {} {:>10}  {:<17} {}{}\n", left(shortened(one.label, 28), 28),
                    right(plus_minus(one.a, one.decimals), 14), right(plus_minus(one.b, one.decimals), 14),
                    signed_number(one.test.difference, one.decimals),
                    bracketed(one.test.interval, one.decimals), holm_p(one), one.p_holm < 0.05 ? " *" : "");
  }
  for (const GameNumber& one : row.game_numbers) {
    text += fmt::format("  {} {}\n", left(shortened(one.label, 28), 28),
                        right(plus_minus(one.value, one.decimals), 14));
  }
  return text;
}

std::string all_statistics(const std::vector<Row>& rows) {
  std::size_t compared = 0;
  for (const Row& row : rows) compared += row.comparisons.empty() ? 0 : 1;
  if (compared == 0) return "";
  if (compared > most_compared) {
    return fmt::format(
        "\nThe match statistics of {} conditions are in the formats markdown, csv, json and in --html.\n",
        compared);
  }
  std::string text;
  for (const Row& row : rows) {
    if (!row.comparisons.empty()) text += statistics(row);
  }
  return text +
         "  a game, over pairs played to their end; *: differs, Holm p under 0.05 among the statistics\n";
}

}  // namespace

std::string as_text(const Summary& summary) {
  const Header& header = summary.header;
  std::string text =
      wrapped(header.design + (header.description.empty() ? "" : ": " + header.description), "  ");
  text += circumstances(summary) + "\n";
  if (!header.stopping.empty()) text += wrapped("stopping: " + header.stopping, "  ");
  text += "\n";
  for (const std::string& answer : header.answers) text += wrapped(answer, "  ");
  if (!header.answers.empty()) text += "\n";
  if (!summary.without_forfeits.empty()) {
    text += fmt::format("Forfeits counted as lost 0:{}\n\n", header.forfeit_goals);
  }
  text += table(header, summary.rows);
  if (!summary.without_forfeits.empty()) {
    text += "\nThe pairs without forfeits alone\n\n" + table(header, summary.without_forfeits);
  }
  for (const PanelComparison& panel : summary.panels) {
    text += "\n" + wrapped(panel.sentence(), "  ");
    text += fmt::format("  {:<30} {:>5} {:>15} {:>15} {:>8}  {:<16} {}\n", "opponent", "pairs", "A", "B",
                        "A - B", "95 %", "p");
    for (const PanelComparison::Line& line : panel.lines) {
      text += fmt::format("  {} {:>5} {} {} {:>8}  {:<16} {}\n", left(shortened(line.opponent, 30), 30),
                          line.pairs, right(signed_plus_minus(line.a), 15),
                          right(signed_plus_minus(line.b), 15), signed_number(line.test.difference, 2),
                          bracketed(line.test.interval), p_value(line.test));
    }
  }
  if (!summary.sweeps.empty()) text += "\nTrends\n";
  for (const Sweep& sweep : summary.sweeps) text += wrapped(sentence(sweep), "  ");
  text += all_statistics(summary.rows) + "\n";
  for (const std::string& note : footnotes(summary)) text += wrapped(note + ".", "  ");
  for (const std::string& warning : warnings(summary)) text += wrapped("Note: " + warning + ".", "  ");
  return console::printable_lines(text);
}

std::string formatted(const Summary& summary, std::string_view format) {
  if (format == "text") return as_text(summary);
  if (format == "markdown") return as_markdown(summary);
  if (format == "csv") return as_csv(summary);
  if (format == "json") return as_json(summary);
  if (format == "latex") return as_latex(summary);
  throw std::invalid_argument("unknown format '" + std::string(format) +
                              "'; known are: text, markdown, csv, json, latex");
}

}  // namespace report
