#pragma once

#include <string>
#include <string_view>

#include "experiments/report/summary.h"

namespace report {

/// For a terminal, at most 100 columns. Match statistics of at most four conditions.
std::string as_text(const Summary& summary);
/// For a web page or a note.
std::string as_markdown(const Summary& summary);
/// For a spreadsheet: a line per condition and way to count forfeits, then one per comparison of a panel, in
/// whose goal_difference columns is A's minus B's against that opponent.
std::string as_csv(const Summary& summary);
/// For a program: everything.
std::string as_json(const Summary& summary);
/// For a paper: the main table, panels, trends and match statistics as tabulars of the package booktabs.
std::string as_latex(const Summary& summary);

/// The report in the format of that name: text, markdown, csv, json or latex.
///
/// @throws std::invalid_argument naming the known ones
std::string formatted(const Summary& summary, std::string_view format);

}  // namespace report
