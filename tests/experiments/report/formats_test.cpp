#include "experiments/report/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "tests/experiments/report/examples.h"

namespace report {
namespace {

using testing::HasSubstr;
using testing::Not;

// The table as it is meant to look, read and agreed on by eye; numbers checked by hand:
// - equal: 0:1 0:2 1:1 1:2 2:1 2:2, so 1-2-3
// - hindered: six wins of six, sign test 2/64, times two conditions
// - pair means -1.5 -0.5 0.5: deviation 1, t(0.975, 2) = 4.303; 6 of 8 sign patterns are as far from zero
// - the two legs rise together, r = 1
TEST(Text, LooksLikeThis) {
  EXPECT_EQ(as_text(example()), R"(night: ours against theirs
rule set ssl-2015, realism measured, seed 7, 3 pairs per condition
12 of 12 games, experiment 0123456789abcdef0123456789abcdef

  team                           games  wins draws  lost   win % [95 %]         goals a game   fouls

equal: no difference shown (p = 0.625; Holm 0.625)
  A ours                             6     1     2     3   16.7 [3.0, 56.4]     1.00 ± 0.37      4.0
  B theirs                           6     3     2     1   50.0 [18.8, 81.2]    1.50 ± 0.22      7.0
  A - B -0.50 ± 0.58 goals a game, 95 %: t [-2.98, 1.98], bootstrap [?, ?]
        sign flips p 0.750 (Holm 0.750); 3 pairs, r within pairs 1.00 ± 0.00; 60.0 stoppages a game

hindered (realism measured with radio.loss 0.2): no difference shown (p = 0.031; Holm 0.063)
  A ours                             6     6     0     0   100.0 [61.0, 100.0]  3.50 ± 0.22      4.0
  B theirs, 3 robots, speed 0.5      6     0     0     6   0.0 [0.0, 39.0]      1.00 ± 0.37      7.0
  A - B +2.50 ± 0.58 goals a game, 95 %: t [0.02, 4.98], bootstrap [?, ?]
        sign flips p 0.250 (Holm 0.500); 3 pairs, r within pairs 1.00 ± 0.00; 60.0 stoppages a game

± is one standard error, intervals are 95 %; win %: Wilson; fouls are calls against the team a game.
p is the exact two-sided sign test of A's wins against its losses; it takes the games of a pair as
  independent, the sign flips do not.
A - B: mean over pairs of games with colours exchanged; sign flips: permutation test over pairs; r:
  correlation.
?: cannot be known from fewer than two pairs (the bootstrap: six), or when all pairs came out alike.
Holm: adjusted for the number of conditions.
Note: equal: 1 void attempt by no fault of a single team, played again.
)");
}

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    // Bytes that continue a character take no column.
    const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
    widest = std::max(widest, static_cast<std::size_t>(columns));
  }
  return widest;
}

TEST(Text, FitsIntoATerminal) {
  EXPECT_LE(widest_line(as_text(example())), 100U);
  EXPECT_LE(widest_line(as_text(sweep_example())), 100U);
}

TEST(Text, TellsTheTrendOfASweepAndTheMatchStatistics) {
  const std::string text = as_text(sweep_example());
  // Goal differences 4, 2, 0 at 0.3, 0.6, 0.9: a slope of -2 / 0.3.
  EXPECT_THAT(text, HasSubstr("speed: A's goal difference changes by -6.67 ["));
  EXPECT_THAT(text, HasSubstr("a game per unit of b.speed_factor"));
  EXPECT_THAT(text, HasSubstr("points of a sweep are not adjusted"));
  EXPECT_THAT(text, Not(HasSubstr("(Holm"))) << "the trend is the only question";
  EXPECT_THAT(text, HasSubstr("shots on target"));
  EXPECT_THAT(text, HasSubstr("longest passage [s]"));
}

TEST(Text, ShowsTheAnswerOfASequentialTestAndWarnsOfThePlainMeans) {
  Summary summary = example();
  summary.header.stopping = "sequential test of A's goal difference";
  summary.header.answers = {"equal: H1 accepted; estimate corrected for the stopping 0.40"};
  for (const std::string& text :
       {as_text(summary), as_markdown(summary), as_latex(summary), as_json(summary)}) {
    EXPECT_THAT(text, HasSubstr("corrected for the stopping 0.40"));
  }
  EXPECT_THAT(as_text(summary), HasSubstr("not corrected for that"));
}

TEST(Markdown, HasOneRowPerCondition) {
  const std::string text = as_markdown(example());
  EXPECT_THAT(text, HasSubstr("| equal | ours | theirs | 6 | 1 | 2 | 3 | 16.7 ["));
  EXPECT_THAT(text, HasSubstr("| hindered, realism measured with radio.loss 0.2 | ours | theirs, 3 robots, "
                              "speed 0.5 | 6 | 6 | 0 | 0 |"));
}

TEST(Csv, HasTheSameNumberOfCellsInEveryLine) {
  std::istringstream lines(as_csv(example()));
  std::vector<long> commas;
  for (std::string line; std::getline(lines, line);)
    commas.push_back(std::count(line.begin(), line.end(), ','));
  ASSERT_EQ(commas.size(), 3U);
  EXPECT_EQ(commas[0], commas[1]);
  EXPECT_EQ(commas[0], commas[2]);
}

TEST(Csv, DoublesQuotesInNames) {
  Header header = example_header();
  header.conditions[0].a.name = "the \"best\"";
  EXPECT_THAT(as_csv(summarise(header, {})), HasSubstr("\"the \"\"best\"\"\""));
}

TEST(Json, HasEveryNumberInFull) {
  const std::string text = as_json(example());
  EXPECT_THAT(text, HasSubstr("\"sign_test_p\": 0.03125"));
  EXPECT_THAT(text, HasSubstr("\"a_robots\": 6"));
  EXPECT_THAT(text, HasSubstr("\"half_length\": null"));
  EXPECT_THAT(text, HasSubstr("\"conditions_without_forfeits\": []"));
  EXPECT_THAT(text, HasSubstr("\"sign_test_p_holm\": 0.0625"));
  EXPECT_THAT(text, HasSubstr("\"sign_flip_p\": 0.25"));
}

TEST(Json, HasSweepsAndStatistics) {
  const std::string text = as_json(sweep_example());
  EXPECT_THAT(text, HasSubstr("\"b.speed_factor\": 0.3"));
  EXPECT_THAT(text, HasSubstr("\"name\": \"possession\""));
  EXPECT_THAT(text, HasSubstr("\"name\": \"foul_AimlessKick\""));
  EXPECT_THAT(text, HasSubstr("\"key\": \"b.speed_factor\""));
}

TEST(Csv, HasColumnsForSweepsAndStatistics) {
  const std::string text = as_csv(sweep_example());
  EXPECT_THAT(text, HasSubstr(",value_b.speed_factor,"));
  EXPECT_THAT(text, HasSubstr(",shots_a,shots_a_standard_error,shots_b,"));
  std::istringstream lines(text);
  std::set<long> commas;
  for (std::string line; std::getline(lines, line);) commas.insert(std::count(line.begin(), line.end(), ','));
  EXPECT_EQ(commas.size(), 1U);
}

TEST(Latex, HasBalancedTabularsAndEscapesNames) {
  Summary summary = sweep_example();
  summary.header.conditions[0].a.name = "50% & more_{}";
  const std::string text = as_latex(summary);
  EXPECT_THAT(text, HasSubstr("50\\% \\& more\\_\\{\\}"));
  const auto count = [&](const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("\\begin{tabular}"), count("\\end{tabular}"));
  EXPECT_THAT(text, HasSubstr("\n\\quad AimlessKick & ")) << "a kind of the line above";
  EXPECT_EQ(count("\\begin{tabular}"), 5U) << "results, trends, three conditions' statistics";
  EXPECT_THAT(text, HasSubstr("$4.00 \\pm 0.00$"));
}

// A's goal differences 3 4 5, B's 1 1 1: 2 3 4 better, mean 3, standard error 1 / sqrt(3),
// t(0.975, 2) = 4.303 of them: 3 -+ 2.48.
TEST(Csv, HasALineForEveryComparisonOfAPanelInTheSameColumns) {
  std::istringstream lines(as_csv(panel_example()));
  std::vector<std::vector<std::string>> table;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    for (table.emplace_back(); std::getline(cells, line, ',');) table.back().push_back(line);
  }
  ASSERT_EQ(table.size(), 4U) << "names, two conditions, one comparison";
  EXPECT_EQ(table[3][0], "panel");
  EXPECT_EQ(table[3][1], "\"league: A minus B against the_rest\"");
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), name) - table[0].begin());
  };
  EXPECT_DOUBLE_EQ(std::stod(table[3].at(column("goal_difference"))), 3);
  EXPECT_NEAR(std::stod(table[3].at(column("goal_difference_t_low"))), 3 - 2.484, 0.001);
  EXPECT_EQ(table[3].at(column("pairs")), "3");
}

TEST(Latex, HasThePanels) {
  const std::string text = as_latex(panel_example());
  EXPECT_THAT(text,
              HasSubstr("the\\_rest & 3 & $4.00 \\pm 0.58$ & $1.00 \\pm 0.00$ & $+3.00$ & [0.52, 5.48] & "
                        "0.035 & $+0.0$ ["));
}

TEST(Json, CountsTheAudits) {
  Summary summary = example();
  summary.header.audits = {{{"equal", 0, 0}, 1, record::Verdict::Same, "x", ""},
                           {{"equal", 1, 0}, 1, record::Verdict::TeamDiffers, "y", ""},
                           {{"equal", 2, 0}, 1, record::Verdict::Same, "x", ""}};
  EXPECT_THAT(as_json(summary), HasSubstr("\"audited\": 3,\n    \"same\": 2,\n    \"team-differs\": 1"));
}

TEST(Formatted, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(formatted(example(), "xml"), std::invalid_argument);
  EXPECT_EQ(formatted(example(), "csv"), as_csv(example()));
}

/// Names that act on a terminal, a page, a spreadsheet or TeX.
Summary hostile() {
  Summary summary = example();
  const std::string evil = "=1+1|`x`<b>\\end{document}\r\x1B[2J\xE2\x80\xAE\xFF";
  summary.header.description = evil;
  summary.header.answers = {evil};
  summary.header.remarks = {evil};
  for (Header::Condition& condition : summary.header.conditions) {
    condition.name = condition.a.name = condition.b.name = evil;
  }
  for (Row& row : summary.rows) row.condition = row.a.name = row.b.name = evil;
  return summary;
}

TEST(EveryFormat, HasNothingThatActsOnATerminal) {
  for (const char* format : {"text", "markdown", "csv", "json", "latex"}) {
    const std::string text = formatted(hostile(), format);
    for (const char* acts : {"\x1B", "\r", "\xE2\x80\xAE", "\xFF"}) {
      EXPECT_THAT(text, Not(HasSubstr(acts))) << format;
    }
  }
}

TEST(Markdown, HasNoMarkupFromNames) {
  EXPECT_THAT(as_markdown(hostile()), HasSubstr("| =1+1\\|\\`x\\`&lt;b>\\\\end{document}"));
}

TEST(Latex, HasNoCommandFromNames) { EXPECT_THAT(as_latex(hostile()), Not(HasSubstr("\n\\end{document}"))); }

TEST(Csv, HasNoFormulaFromNames) {
  EXPECT_THAT(as_csv(hostile()), HasSubstr("\ncounted,\"'=1+1|`x`<b>\\end"));
}

TEST(Csv, HasOneColumnForAKeyWhateverIsInIt) {
  Summary summary = example();
  summary.header.conditions[0].values["a.--flag,\"x\"\n=1"] = 2;
  const std::string text = as_csv(summary);
  EXPECT_THAT(text, HasSubstr(",\"value_a.--flag,\"\"x\"\" =1\""));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3) << "the names, two conditions";
}

}  // namespace
}  // namespace report
