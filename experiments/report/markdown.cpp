#include <fmt/format.h>

#include "experiments/report/formats.h"
#include "experiments/report/wording.h"
#include "sim/console/printable.h"

namespace report {
namespace {

/// A text as a cell or a sentence: one line without markup. A bar would end the cell, and pages take HTML.
std::string cell(const std::string& text) {
  std::string result;
  for (const char letter : console::printable(text)) {
    if (letter == '<') {
      result += "&lt;";
      continue;
    }
    if (letter == '&') {
      result += "&amp;";
      continue;
    }
    const bool link = letter == '(' && result.ends_with(']');
    if (letter == '|' || letter == '`' || letter == '\\' || link) result += '\\';
    result += letter;
  }
  return result;
}

std::string table(const Header& header, const std::vector<Row>& rows) {
  std::string text =
      "| condition | A | B | games | A wins | draws | B wins | A win % [95 %] | B win % [95 %] | A goals | B "
      "goals "
      "| A - B | t [95 %] | bootstrap [95 %] | p wins | p sign flips | within pairs | fouls A / B | "
      "stoppages "
      "| verdict |\n"
      "|---|---|---|---:|---:|---:|---:|---|---|---|---|---|---|---|---|---|---|---|---:|---|\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} ",
                        cell(header.conditions[i].realism == header.realism
                                 ? row.condition
                                 : row.condition + ", realism " + header.conditions[i].realism),
                        cell(described(header.conditions[i].a)), cell(described(header.conditions[i].b)),
                        row.games, row.a.wins, row.draws, row.b.wins, percent(row.a, row.games),
                        percent(row.b, row.games), plus_minus(row.a.goals), plus_minus(row.b.goals),
                        signed_plus_minus(row.difference));
    text += fmt::format("| {} | {} | {} | {} | {} | {} / {} | {} | {} |\n", bracketed(row.t_test.interval),
                        bracketed(row.bootstrap), p_value(row.p, row.p_holm),
                        p_value(row.permutation_p, row.permutation_p_holm), correlation(row.correlation),
                        one_decimal(row.a.fouls), one_decimal(row.b.fouls), one_decimal(row.stoppages),
                        row.verdict());
  }
  return text;
}

std::string statistics(const Row& row) {
  std::string text =
      "\n### Match statistics, " + cell(row.condition) +
      "\n\n| a game | A | B | A - B | [95 %] | p | Holm p |\n|---|---:|---:|---:|---|---:|---:|\n";
  for (const Comparison& one : row.comparisons) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", cell(one.label),
                        plus_minus(one.a, one.decimals), plus_minus(one.b, one.decimals),
                        signed_number(one.test.difference, one.decimals),
                        bracketed(one.test.interval, one.decimals), p_value(one.test), holm_p(one));
  }
  for (const GameNumber& one : row.game_numbers) {
    text += fmt::format("| {} | {} | | | | | |\n", cell(one.label), plus_minus(one.value, one.decimals));
  }
  return text;
}

}  // namespace

std::string as_markdown(const Summary& summary) {
  const Header& header = summary.header;
  std::string text = "## " + cell(header.design) + "\n\n";
  if (!header.description.empty()) text += cell(header.description) + "\n\n";
  text += console::printable_lines(circumstances(summary)) + "\n\n";
  if (!header.stopping.empty()) text += "Stopping: " + header.stopping + "\n\n";
  for (const std::string& answer : header.answers) text += "**" + cell(answer) + "**\n\n";
  text += table(header, summary.rows);
  if (!summary.without_forfeits.empty()) {
    text += fmt::format("\nForfeits counted above as lost 0:{}. The pairs without forfeits alone:\n\n",
                        header.forfeit_goals) +
            table(header, summary.without_forfeits);
  }
  for (const PanelComparison& panel : summary.panels) {
    text += "\n### " + cell(panel.title()) + "\n\n" + cell(panel.sentence()) +
            "\n\n| opponent | pairs | A | B | A - B | [95 %] | p | win % A - B [95 %] |\n"
            "|---|---:|---|---|---|---|---|---|\n";
    for (const PanelComparison::Line& line : panel.lines) {
      const stats::Interval& share = line.win_share_interval;
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} {} |\n", cell(line.opponent), line.pairs,
                          signed_plus_minus(line.a), signed_plus_minus(line.b),
                          signed_number(line.test.difference, 2), bracketed(line.test.interval),
                          p_value(line.test), signed_number(100 * line.win_share, 1),
                          bracketed({100 * share.low, 100 * share.high}, 1));
    }
  }
  if (!summary.sweeps.empty()) text += "\n### Trends\n\n";
  for (const Sweep& sweep : summary.sweeps) text += "* " + cell(sentence(sweep)) + "\n";
  for (const Row& row : summary.rows) {
    if (!row.comparisons.empty()) text += statistics(row);
  }
  text += "\n";
  for (const std::string& note : footnotes(summary)) text += note + ".\n";
  for (const std::string& warning : warnings(summary)) text += "\nNote: " + cell(warning) + ".\n";
  return text;
}

}  // namespace report
