#include <fmt/format.h>

#include "experiments/report/formats.h"
#include "experiments/report/wording.h"
#include "sim/console/printable.h"

namespace report {
namespace {

/// A text in which nothing is a command.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : console::printable(text)) {
    switch (letter) {
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        result += std::string("\\") + letter;
        break;
      case '~':
        result += "\\textasciitilde{}";
        break;
      case '^':
        result += "\\textasciicircum{}";
        break;
      case '\\':
        result += "\\textbackslash{}";
        break;
      case '<':
        result += "$<$";
        break;
      case '>':
        result += "$>$";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

std::string comment(const std::string& text) {
  std::string result = "% ";
  for (const char letter : console::printable_lines(text))
    result += letter == '\n' ? std::string("\n% ") : std::string(1, letter);
  return result + "\n";
}

std::string share(std::int64_t count, std::int64_t games) {
  return games > 0 ? fmt::format("{:.2f}", 100.0 * static_cast<double>(count) / static_cast<double>(games))
                   : "--";
}

std::string interval(const stats::Interval& found, double factor, int decimals) {
  return fmt::format("[{:.{}f}, {:.{}f}]", factor * found.low, decimals, factor * found.high, decimals);
}

std::string with_error(const stats::Mean& mean, int decimals) {
  if (mean.count == 0) return "--";
  if (!mean.has_error()) return fmt::format("${:.{}f}$", mean.mean, decimals);
  return fmt::format("${:.{}f} \\pm {:.{}f}$", mean.mean, decimals, mean.standard_error, decimals);
}

/// As the paper's Table 7: a line for each of the two teams.
std::string side_line(const std::string& condition, const std::string& team, const Row& row,
                      const Side& side) {
  return fmt::format("{} & {} & {} & {} & {} & {} \\\\\n", condition, escaped(team),
                     share(side.wins, row.games), interval(side.win_share, 100, 1), with_error(side.goals, 2),
                     side.forfeits);
}

std::string table(const Header& header, const std::vector<Row>& rows) {
  std::string text =
      "\\begin{tabular}{llrcrr}\n\\toprule\ncondition & team & win \\% & 95 \\% & goals a game & forfeits "
      "\\\\\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    text += "\\midrule\n" +
            side_line(escaped(titled(header, i)), described('A', header.conditions[i].a), row, row.a);
    text += side_line(fmt::format("{} games, {} \\% drawn", row.games, share(row.draws, row.games)),
                      described('B', header.conditions[i].b), row, row.b);
    if (row.difference.count == 0) continue;
    text += fmt::format(
        "\\multicolumn{{6}}{{l}}{{\\quad A $-$ B {} goals a game, 95 \\%: $t$ {}, bootstrap {}; sign flips "
        "$p$ {}; "
        "within pairs {}}} \\\\\n",
        with_error(row.difference, 2), escaped(bracketed(row.t_test.interval)),
        escaped(bracketed(row.bootstrap)), escaped(p_value(row.permutation_p, row.permutation_p_holm)),
        row.correlation.known
            ? fmt::format("${:.2f} \\pm {:.2f}$", row.correlation.value, row.correlation.standard_error)
            : "unknown");
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string statistics(const Row& row) {
  std::string text =
      "\n" + comment("match statistics, " + row.condition) +
      "\\begin{tabular}{lrrrcr}\n\\toprule\na game & A & B & A $-$ B & 95 \\% & Holm $p$ \\\\\n\\midrule\n";
  for (const Comparison& one : row.comparisons) {
    const bool part = one.label.starts_with(' ');
    text += fmt::format("{}{} & {} & {} & ${}$ & {} & {} \\\\\n", part ? "\\quad " : "",
                        escaped(part ? one.label.substr(2) : one.label), with_error(one.a, one.decimals),
                        with_error(one.b, one.decimals), signed_number(one.test.difference, one.decimals),
                        bracketed(one.test.interval, one.decimals), escaped(holm_p(one)));
  }
  for (const GameNumber& one : row.game_numbers) {
    text += fmt::format("{} & \\multicolumn{{2}}{{c}}{{{}}} & & & \\\\\n", escaped(one.label),
                        with_error(one.value, one.decimals));
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string panel(const PanelComparison& found) {
  std::string text = comment(found.sentence()) +
                     "\\begin{tabular}{lrrrrcrc}\n\\toprule\n"
                     "opponent & pairs & A & B & A $-$ B & 95 \\% & $p$ & win \\% A $-$ B, 95 \\% \\\\\n"
                     "\\midrule\n";
  for (const PanelComparison::Line& line : found.lines) {
    text +=
        fmt::format("{} & {} & {} & {} & ${}$ & {} & {} & ${}$ {} \\\\\n", escaped(line.opponent), line.pairs,
                    with_error(line.a, 2), with_error(line.b, 2), signed_number(line.test.difference, 2),
                    bracketed(line.test.interval), escaped(p_value(line.test)),
                    signed_number(100 * line.win_share, 1), interval(line.win_share_interval, 100, 1));
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string trends(const std::vector<Sweep>& sweeps) {
  std::string text =
      "\n\\begin{tabular}{llrcrr}\n\\toprule\nsweep & value & slope & 95 \\% & $p$ & permutation $p$ "
      "\\\\\n\\midrule\n";
  for (const Sweep& sweep : sweeps) {
    if (!sweep.trend.known) continue;
    text += fmt::format("{} & {} & ${:+.3g}$ & [{:.3g}, {:.3g}] & {} & {} \\\\\n", escaped(sweep.name),
                        escaped(sweep.key), sweep.trend.slope, sweep.trend.interval.low,
                        sweep.trend.interval.high, escaped(p_value(sweep.trend.p)),
                        escaped(p_value(sweep.trend.permutation_p)));
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

}  // namespace

std::string as_latex(const Summary& summary) {
  const Header& header = summary.header;
  std::string text = comment(header.design + (header.description.empty() ? "" : ": " + header.description));
  text += comment(circumstances(summary));
  text += comment("needs \\usepackage{booktabs}");
  if (!header.stopping.empty()) text += comment("stopping: " + header.stopping);
  for (const std::string& answer : header.answers) text += comment(answer);
  for (const std::string& note : footnotes(summary)) text += comment(note);
  for (const std::string& warning : warnings(summary)) text += comment("Note: " + warning);
  text += table(header, summary.rows);
  if (!summary.without_forfeits.empty()) {
    text += "\n% the pairs without forfeits alone\n" + table(header, summary.without_forfeits);
  }
  for (const PanelComparison& one : summary.panels) text += "\n" + panel(one);
  if (!summary.sweeps.empty()) text += trends(summary.sweeps);
  for (const Row& row : summary.rows) {
    if (!row.comparisons.empty()) text += statistics(row);
  }
  return text;
}

}  // namespace report
