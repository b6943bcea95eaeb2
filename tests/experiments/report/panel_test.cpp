#include "experiments/report/panel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/report/examples.h"

namespace report {
namespace {

using testing::HasSubstr;

PanelGames games_of(const std::string& team, std::int64_t wins, std::map<int, double> differences) {
  return {team, wins, 2 * static_cast<std::int64_t>(differences.size()), std::move(differences)};
}

// A 1 2 3 and B 0 0 1 in pairs 0 1 2: differences 1 2 2, mean 5/3; pair 3 of A has no partner.
TEST(ComparePanel, ComparesPairByPair) {
  const PanelComparison panel =
      compare_panel("base", {{"x",
                              {games_of("new", 4, {{0, 1}, {1, 2}, {2, 3}, {3, 99}}),
                               games_of("old", 1, {{0, 0}, {1, 0}, {2, 1}})}}});
  ASSERT_EQ(panel.lines.size(), 1U);
  EXPECT_EQ(panel.lines[0].pairs, 3);
  EXPECT_NEAR(panel.lines[0].test.difference, 5.0 / 3, 1e-12);
  EXPECT_NEAR(panel.lines[0].test.standard_error, 1.0 / 3, 1e-12);
  EXPECT_NEAR(panel.lines[0].win_share, 4.0 / 8 - 1.0 / 6, 1e-12);
  EXPECT_THAT(panel.sentence(), HasSubstr("A (new) compared with B (old)"));
}

// Against x A is 1 better, against y 3 better: 2 on average, and only pairs there for both count.
TEST(ComparePanel, TakesTheMeanOverTheOpponents) {
  const PanelComparison panel = compare_panel(
      "base",
      {{"x", {games_of("new", 0, {{0, 1}, {1, 2}}), games_of("old", 0, {{0, 0}, {1, 1}})}},
       {"y", {games_of("new", 0, {{0, 3}, {1, 4}, {2, 9}}), games_of("old", 0, {{0, 0}, {1, 1}, {2, 0}})}}});
  ASSERT_EQ(panel.lines.size(), 3U);
  EXPECT_EQ(panel.lines[2].opponent, "all");
  EXPECT_EQ(panel.lines[2].pairs, 2);
  EXPECT_DOUBLE_EQ(panel.lines[2].test.difference, 2);
}

TEST(ComparePanel, SaysThatThereIsTooLittle) {
  const PanelComparison panel =
      compare_panel("base", {{"x", {games_of("new", 0, {}), games_of("old", 0, {})}}});
  EXPECT_THAT(panel.sentence(), HasSubstr("too few pairs"));
}

TEST(Summary, ComparesTheArmsOfAPanel) {
  Header header = example_header();
  header.conditions[0].panel = Header::Condition::Panel{"base", "x", 'a'};
  header.conditions[1].panel = Header::Condition::Panel{"base", "x", 'b'};
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 3; ++pair) {
    for (int leg = 0; leg < 2; ++leg) {
      games.push_back(game("equal", pair, leg, 3 + pair, 0));
      games.push_back(game("hindered", pair, leg, 1, 0));
    }
  }
  const Summary summary = summarise(header, games);
  ASSERT_EQ(summary.panels.size(), 1U);
  EXPECT_DOUBLE_EQ(summary.panels[0].lines[0].test.difference, 3);
  EXPECT_FALSE(summary.rows[0].p_holm) << "A against B is the question, not A against x";
}

}  // namespace
}  // namespace report
