#include "experiments/report/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "tests/experiments/report/examples.h"

namespace report {
namespace {

using testing::HasSubstr;

Summary example() {
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 3; ++pair) {
    for (int leg = 0; leg < 2; ++leg) {
      games.push_back(game("equal", pair, leg, pair, leg + 1));
      games.push_back(game("hindered", pair, leg, 3 + leg, pair));
    }
  }
  games.push_back(spoilt(games[0]));
  games.back().key.pair = 7;
  return summarise(example_header(), games);
}

// The table as it is meant to look, read and agreed on by eye; numbers checked by hand:
// equal: 0:1 0:2 1:1 1:2 2:1 2:2, so 1-2-3; hindered: six wins of six, sign test 2/64.
TEST(Text, LooksLikeThis) {
  EXPECT_EQ(as_text(example()), R"(night: ours against theirs
rule set ssl-2015, realism measured, seed 7, 3 pairs per condition
12 of 12 games, experiment 0123456789abcdef0123456789abcdef

  team                              games  wins draws  lost   win % [95 %]         goals a game   fouls

equal: no difference shown (p = 0.625)
  A ours                                6     1     2     3   16.7 [3.0, 56.4]     1.00 ± 0.37      4.0
  B theirs                              6     3     2     1   50.0 [18.8, 81.2]    1.50 ± 0.22      7.0
  A - B -0.50 ± 0.58 goals a game over 3 pairs, 60.0 stoppages a game

hindered (realism measured with radio.loss 0.2): A wins more games than it loses (p = 0.031)
  A ours                                6     6     0     0   100.0 [61.0, 100.0]  3.50 ± 0.22      4.0
  B theirs, 3 robots, speed 0.5         6     0     0     6   0.0 [0.0, 39.0]      1.00 ± 0.37      7.0
  A - B +2.50 ± 0.58 goals a game over 3 pairs, 60.0 stoppages a game

± is one standard error; fouls are calls against the team per game;
p is the exact two-sided sign test of A's wins against its losses.
Note: equal: 1 void attempt by no fault of a single team, played again.
)");
}

TEST(Text, FitsIntoATerminal) {
  std::istringstream lines(as_text(example()));
  for (std::string line; std::getline(lines, line);) {
    // Bytes that continue a character take no column.
    const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
    EXPECT_LE(columns, 110) << line;
  }
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
}

TEST(Formatted, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(formatted(example(), "xml"), std::invalid_argument);
  EXPECT_EQ(formatted(example(), "csv"), as_csv(example()));
}

}  // namespace
}  // namespace report
