#include "experiments/report/html.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>

#include "experiments/process/whole_file.h"
#include "experiments/record/ledger.h"
#include "experiments/report/html_style.h"
#include "experiments/report/markup.h"
#include "experiments/report/wording.h"
#include "sim/files/regular_file.h"

namespace report {
namespace {

constexpr int refresh_seconds = 20;
constexpr std::size_t longest_manifest = std::size_t{64} << 20;  // [bytes] as in runner/manifest_reader

std::string cell(const std::string& text, const char* kind = "") {
  return std::string("<td") + (*kind != '\0' ? std::string(" class=\"") + kind + "\"" : "") + ">" +
         escaped(text) + "</td>";
}

/// A cell that is sorted by a number.
std::string cell(const std::string& text, double value) {
  return fmt::format("<td data-v=\"{:.9g}\">{}</td>", value, escaped(text));
}

std::string heads(const std::vector<std::string>& names) {
  std::string text = "<thead><tr>";
  for (const std::string& name : names) text += "<th>" + escaped(name) + "</th>";
  return text + "</tr></thead>\n";
}

/// Wins of A, draws and wins of B as a coloured bar.
std::string bar(const Row& row) {
  if (row.games == 0) return "<td></td>";
  const auto part = [&](const char* kind, std::int64_t count) {
    return fmt::format("<i class=\"{}\" style=\"width:{:.2f}%\"></i>", kind,
                       100.0 * static_cast<double>(count) / static_cast<double>(row.games));
  };
  return fmt::format("<td class=\"left\"><span class=\"bar\" title=\"{} : {} : {}\">", row.a.wins, row.draws,
                     row.b.wins) +
         part("a", row.a.wins) + part("d", row.draws) + part("b", row.b.wins) + "</span></td>";
}

std::string results(const Header& header, const std::vector<Row>& rows) {
  std::string text = "<div class=\"wide\"><table>" +
                     heads({"condition", "", "games", "A wins", "draws", "B wins", "A win % [95 %]",
                            "B win % [95 %]", "A goals", "B goals"}) +
                     "<tbody>\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    text += "<tr>" + fmt::format("<td><b>{}</b><br><span class=\"dim small\">{} &ndash; {}</span></td>",
                                 escaped(titled(header, i)), escaped(described('A', header.conditions[i].a)),
                                 escaped(described('B', header.conditions[i].b)));
    text += bar(row) + cell(std::to_string(row.games)) + cell(std::to_string(row.a.wins)) +
            cell(std::to_string(row.draws)) + cell(std::to_string(row.b.wins)) +
            cell(percent(row.a, row.games)) + cell(percent(row.b, row.games)) +
            cell(plus_minus(row.a.goals)) + cell(plus_minus(row.b.goals)) + "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string differences(const std::vector<Row>& rows) {
  std::string text = "<div class=\"wide\"><table>" +
                     heads({"A - B, goals a game", "pairs", "mean ± SE", "t [95 %]", "bootstrap [95 %]",
                            "p sign flips", "p wins against losses", "r within pairs"}) +
                     "<tbody>\n";
  for (const Row& row : rows) {
    const bool shown = row.shows_difference();
    text += std::string("<tr") + (shown ? " class=\"sig\"" : "") + ">" + cell(row.condition) +
            cell(std::to_string(row.difference.count)) + cell(signed_plus_minus(row.difference)) +
            cell(bracketed(row.t_test.interval)) + cell(bracketed(row.bootstrap)) +
            cell(p_value(row.permutation_p, row.permutation_p_holm)) + cell(p_value(row.p, row.p_holm)) +
            cell(correlation(row.correlation)) + "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

/// What else was counted in the games of each condition.
std::string counts(const std::vector<Row>& rows) {
  std::string text = "<div class=\"wide\"><table>" +
                     heads({"condition", "games", "stoppages a game", "fouls a game A / B", "forfeits A / B",
                            "void attempts", "pairs given up"}) +
                     "<tbody>\n";
  for (const Row& row : rows) {
    text += "<tr>" + cell(row.condition) + cell(std::to_string(row.games)) +
            cell(one_decimal(row.stoppages)) +
            cell(one_decimal(row.a.fouls) + " / " + one_decimal(row.b.fouls)) +
            cell(fmt::format("{} / {}", row.a.forfeits, row.b.forfeits)) +
            cell(std::to_string(row.void_attempts)) + cell(std::to_string(row.given_up_pairs)) + "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

/// A and B against the same opponents.
std::string panels(const std::vector<PanelComparison>& all) {
  std::string text;
  for (const PanelComparison& panel : all) {
    text += "<h3>" + escaped(panel.title()) + "</h3>\n<div class=\"wide\"><table>" +
            heads({"opponent", "pairs", "A", "B", "A's minus B's goal difference", "95 %", "p",
                   "A's minus B's win %", "95 %"}) +
            "<tbody>\n";
    for (const PanelComparison::Line& line : panel.lines) {
      text += "<tr>" + cell(line.opponent) + cell(std::to_string(line.pairs)) +
              cell(signed_plus_minus(line.a)) + cell(signed_plus_minus(line.b)) +
              cell(signed_number(line.test.difference, 2)) + cell(bracketed(line.test.interval)) +
              cell(p_value(line.test)) + cell(signed_number(100 * line.win_share, 1)) +
              cell(bracketed({100 * line.win_share_interval.low, 100 * line.win_share_interval.high}, 1)) +
              "</tr>\n";
    }
    text += "</tbody></table></div>\n";
  }
  return text;
}

std::string statistics(const Row& row, bool open) {
  std::string text = fmt::format("<details{}><summary>{}</summary><div class=\"wide\"><table>",
                                 open ? " open" : "", escaped(row.condition)) +
                     heads({"a game", "A", "B", "A - B", "95 %", "p", "Holm p"}) + "<tbody>\n";
  for (const Comparison& one : row.comparisons) {
    text += std::string("<tr") + (one.p_holm < 0.05 ? " class=\"sig\"" : "") + ">" +
            (one.label.starts_with(' ') ? cell(one.label.substr(2), "part") : cell(one.label)) +
            cell(plus_minus(one.a, one.decimals)) + cell(plus_minus(one.b, one.decimals)) +
            cell(signed_number(one.test.difference, one.decimals)) +
            cell(bracketed(one.test.interval, one.decimals)) + cell(p_value(one.test)) + cell(holm_p(one)) +
            "</tr>\n";
  }
  for (const GameNumber& one : row.game_numbers) {
    text += "<tr>" + cell(one.label) + "<td colspan=\"2\">" + escaped(plus_minus(one.value, one.decimals)) +
            "</td><td></td><td></td><td></td><td></td></tr>\n";
  }
  return text + "</tbody></table></div></details>\n";
}

std::string all_statistics(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    if (!row.comparisons.empty()) text += statistics(row, text.empty());
  }
  if (text.empty()) return "";
  return "<h2>Match statistics</h2>\n<p class=\"dim small\">Counted from the truth, mean a game over pairs "
         "played to "
         "their end ± one standard error; bold: differs, Holm p under 0.05 among the statistics of its "
         "condition.</p>\n" +
         text;
}

std::string drawings(const Page& page) {
  if (page.figures.empty() && page.no_figures.empty()) return "";
  std::string text = "<h2>Figures</h2>\n";
  if (!page.no_figures.empty()) return text + "<p class=\"warn\">" + escaped(page.no_figures) + "</p>\n";
  text += "<div class=\"figures\">\n";
  for (const auto& [figure, svg] : page.figures) {
    const std::size_t begin = svg.find("<svg");  // what is before it belongs to a file of its own
    text += "<figure>" + svg.substr(begin == std::string::npos ? 0 : begin) + "<figcaption>" +
            escaped(figure.caption) + "</figcaption></figure>\n";
  }
  return text + "</div>\n";
}

std::string audit_section(std::span<const record::Audit> audits) {
  std::string text = "<h3>Do games played again go the same way?</h3>\n";
  if (audits.empty()) {
    return text +
           "<p class=\"dim small\">No game was played again (limits.audited is the share that is).</p>\n";
  }
  text += fmt::format("<p>{} game{} played again to compare hashes.</p>\n<table>", audits.size(),
                      audits.size() == 1 ? " was" : "s were") +
          heads({"games", "finding", "which"}) + "<tbody>\n";
  for (const AuditLine& line : audit_lines(audits)) {
    const bool bad = line.verdict != record::Verdict::Same;
    text += std::string("<tr") + (bad ? " class=\"bad\"" : "") + ">" + cell(std::to_string(line.count)) +
            cell(line.meaning(), "left wrap") + cell(line.games, "left wrap") + "</tr>\n";
  }
  return text + "</tbody></table>\n";
}

std::string health_section(const Health& health, const Summary& summary) {
  std::string text = "<h2>Health of the run</h2>\n";
  text += fmt::format(
      "<p>{} attempts: {} games played to their end, {} forfeits, {} void. {} of {} games are "
      "distinct.</p>\n",
      health.attempts, health.finished, health.forfeits, health.voids, health.distinct, health.finished);
  for (const std::string& warning : warnings(summary))
    text += "<p class=\"warn\">" + escaped(warning) + ".</p>\n";
  if (!health.faults.empty()) {
    text += "<table>" + heads({"fault", "games"}) + "<tbody>";
    for (const auto& [fault, count] : health.faults)
      text += "<tr>" + cell(fault) + cell(std::to_string(count)) + "</tr>";
    text += "</tbody></table>\n<details><summary>the last of them</summary><ul class=\"small\">";
    for (const std::string& reason : health.reasons) text += "<li>" + escaped(reason) + "</li>";
    text += "</ul></details>\n";
  }
  text +=
      "<h3>Do games look alike wherever and whenever they were played?</h3>\n<p class=\"dim small\">A's "
      "wins, draws "
      "and losses by things that should not matter; suspicious: p under 0.01, adjusted for the number of "
      "checks. "
      "Colour, end and kickoff may matter to a team; pairs take colour out of the results.</p>\n<table>" +
      heads({"by", "groups", "finding"}) + "<tbody>\n";
  for (const Health::Check& check : health.checks) {
    const bool bad = check.result.freedom > 0 && check.p_holm < suspicious;
    text += std::string("<tr") + (bad ? " class=\"bad\"" : "") + ">" + cell(check.what) +
            cell(std::to_string(check.result.rows.size())) + cell(check.text(), "left wrap") + "</tr>\n";
  }
  const stats::RunsTest& runs = health.runs;
  const bool drift = runs.p < suspicious;
  text += std::string("<tr") + (drift ? " class=\"bad\"" : "") + ">" + cell("order of the schedule") +
          cell("") +
          cell(runs.expected > 0
                   ? fmt::format("{} runs above and below the median, {:.0f} expected, p = {:.3f}{}",
                                 runs.runs, runs.expected, runs.p, drift ? ": SUSPICIOUS" : "")
                   : std::string("too few games to say"),
               "left wrap") +
          "</tr>\n</tbody></table>\n";
  return text + audit_section(summary.header.audits);
}

std::string games(std::span<const record::Attempt> attempts) {
  std::string text =
      "<h2>Games</h2>\n<p class=\"dim small\">A click on a heading sorts. <code>matchday replay FOLDER "
      "GAME</code> "
      "plays one again.</p>\n<div class=\"wide\"><table class=\"games\">" +
      heads({"game", "attempt", "A is", "A", "B", "ended", "at fault", "minutes", "stoppages", "shots A",
             "shots B", "fouls A", "fouls B", "wall [s]", "worker", "started", "seed", "hash"}) +
      "<tbody>\n";
  for (const record::Attempt& attempt : attempts) {
    const record::MatchRecord& record = attempt.record;
    const world::Team a = attempt.a_colour;
    const world::Team b = world::opponent(a);
    const bool bad = record.at_fault != record::Party::Nobody;
    const auto count = [](int number) { return cell(std::to_string(number), number); };
    const auto shots = [&](world::Team team) {
      return record.statistics ? count(record.statistics->teams[team].shots) : cell("", -1.0);
    };
    const double minutes = static_cast<double>(record.ticks) / world::ticks_per_second / 60;
    std::string fault = record::name(record.at_fault);
    if (record.at_fault == record::party(a)) fault = "A";
    if (record.at_fault == record::party(b)) fault = "B";
    text += std::string("<tr") + (bad ? " class=\"bad\" title=\"" + escaped(record.reason) + "\"" : "") +
            ">" + cell(record::game_id(attempt.key)) + count(attempt.attempt) + cell(world::name(a)) +
            count(record.goals[a]) + count(record.goals[b]) + cell(record::name(record.termination)) +
            cell(bad ? fault : "") + cell(fmt::format("{:.1f}", minutes), minutes) + count(record.stoppages) +
            shots(a) + shots(b) + count(record.fouls[a]) + count(record.fouls[b]) +
            cell(fmt::format("{:.1f}", record.wall_seconds), record.wall_seconds) + count(attempt.worker) +
            cell(attempt.started) + cell(std::to_string(attempt.seed)) +
            fmt::format("<td title=\"{0}\"><code>{1}</code></td>", escaped(record.hash),
                        escaped(record.hash.substr(0, 8))) +
            "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

std::string lead(const Summary& summary) {
  const Header& header = summary.header;
  std::string text = "<div class=\"lead\">\n";
  for (const std::string& answer : header.answers) text += "<p><b>" + escaped(answer) + "</b></p>\n";
  constexpr std::size_t most_told = 6;
  std::size_t told = 0;
  for (std::size_t i = 0; i < summary.rows.size() && header.answers.empty(); ++i) {
    const Row& row = summary.rows[i];
    if (!header.conditions[i].sweep.empty() || told >= most_told) continue;
    ++told;
    text += fmt::format("<p><b>{}</b>: {}", escaped(titled(header, i)), escaped(row.verdict()));
    if (row.difference.count > 0) {
      text += fmt::format("; A - B {} goals a game {}", escaped(signed_plus_minus(row.difference)),
                          escaped(bracketed(row.t_test.interval)));
    }
    text += "</p>\n";
  }
  for (const PanelComparison& panel : summary.panels) text += "<p>" + escaped(panel.sentence()) + "</p>\n";
  for (const Sweep& sweep : summary.sweeps) text += "<p><b>Trend</b> " + escaped(sentence(sweep)) + "</p>\n";
  return text + "</div>\n";
}

}  // namespace

std::string as_html(const Page& page) {
  const Summary& summary = page.summary;
  const Header& header = summary.header;
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  if (page.refresh) text += fmt::format("<meta http-equiv=\"refresh\" content=\"{}\">\n", refresh_seconds);
  text += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
          escaped(header.design) + "</title>\n<style>" + page_style + "</style>\n</head>\n<body>\n";
  text += "<h1>" + escaped(header.design) + "</h1>\n<p>" + escaped(header.description) + "</p>\n";
  const double share = summary.planned > 0
                           ? 100.0 * static_cast<double>(summary.games) / static_cast<double>(summary.planned)
                           : 0;
  text +=
      fmt::format("<div class=\"progress\"><i style=\"width:{:.1f}%\"></i></div>\n", std::min(share, 100.0));
  text +=
      "<p class=\"dim small\">" + escaped(circumstances(summary)) + "<br>page made " + escaped(page.made) +
      (page.refresh ? ", loads itself again every " + std::to_string(refresh_seconds) + " s" : "") + "</p>\n";
  if (!header.stopping.empty())
    text += "<p class=\"dim small\">Stopping: " + escaped(header.stopping) + "</p>\n";
  text += lead(summary);

  text +=
      "<h2>Results</h2>\n<p class=\"key\"><i style=\"background:var(--a)\"></i>A wins"
      "<i style=\"background:var(--draw)\"></i>draws<i style=\"background:var(--b)\"></i>B wins</p>\n";
  if (!summary.without_forfeits.empty())
    text += fmt::format("<p>Forfeits counted as lost 0:{}.</p>\n", header.forfeit_goals);
  text += results(header, summary.rows) + "<h3>Goal difference</h3>\n" + differences(summary.rows);
  if (!summary.without_forfeits.empty()) {
    text += "<h3>The pairs without forfeits alone</h3>\n" + results(header, summary.without_forfeits) +
            differences(summary.without_forfeits);
  }
  text += panels(summary.panels) + "<h3>Counts</h3>\n" + counts(summary.rows) + "<p class=\"dim small\">";
  for (const std::string& note : footnotes(summary)) text += escaped(note) + ".<br>";
  text += "</p>\n";
  text += drawings(page) + all_statistics(summary.rows) + health_section(page.health, summary) +
          games(page.attempts);
  if (!page.manifest.empty()) {
    text += "<h2>Manifest</h2>\n<details><summary>how to make this folder again</summary><pre>" +
            escaped_lines(page.manifest) + "</pre></details>\n";
  }
  return text + "<script>" + page_script + "</script>\n</body>\n</html>\n";
}

std::filesystem::path write_html(const std::filesystem::path& folder, const Summary& summary,
                                 std::span<const record::Attempt> attempts, bool goes_on) {
  Page page;
  page.summary = summary;
  page.health = health_of(attempts);
  page.attempts = attempts;
  page.refresh = goes_on;
  page.made = fmt::format("{:%Y-%m-%d %H:%M:%S} UTC", fmt::gmtime(std::time(nullptr)));
  try {
    for (Figure& figure : figures(summary)) {
      std::string svg = drawn(figure);
      page.figures.emplace_back(std::move(figure), std::move(svg));
    }
  } catch (const DrawingError& error) {
    page.figures.clear();
    page.no_figures = error.what();
  }
  if (std::filesystem::exists(folder / "manifest.json")) {
    try {
      page.manifest = files::text_of(folder / "manifest.json", longest_manifest);
    } catch (const std::runtime_error& error) {
      throw record::StorageError(error.what());
    }
  }

  const std::filesystem::path file = folder / "report.html";
  process::write_whole(file, as_html(page));
  return file;
}

}  // namespace report
