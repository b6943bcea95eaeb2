#include "experiments/report/summary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/report/examples.h"

namespace report {
namespace {

TEST(Summary, CountsFromTeamAsView) {
  const std::vector<record::Attempt> games = {game("equal", 0, 0, 3, 0), game("equal", 0, 1, 2, 2),
                                              game("equal", 1, 0, 0, 1), game("equal", 1, 1, 4, 0)};
  const Summary summary = summarise(example_header(), games);
  ASSERT_EQ(summary.rows.size(), 2U);
  const Row& row = summary.rows[0];
  EXPECT_EQ(row.games, 4);
  EXPECT_EQ(row.a.wins, 2);
  EXPECT_EQ(row.draws, 1);
  EXPECT_EQ(row.b.wins, 1);
  EXPECT_DOUBLE_EQ(row.a.goals.mean, 9.0 / 4);
  EXPECT_DOUBLE_EQ(row.b.goals.mean, 3.0 / 4);
  EXPECT_DOUBLE_EQ(row.a.fouls, 4);
  EXPECT_DOUBLE_EQ(row.b.fouls, 7);
  EXPECT_DOUBLE_EQ(row.stoppages, 60);
  EXPECT_EQ(summary.games, 4);
  EXPECT_EQ(summary.planned, 12);
  EXPECT_EQ(summary.rows[1].games, 0);
}

TEST(Summary, TakesTheDifferenceOverPairs) {
  // Pair means +1.5 and +1.5: no spread between pairs, although the games differ.
  const std::vector<record::Attempt> games = {game("equal", 0, 0, 3, 0), game("equal", 0, 1, 0, 0),
                                              game("equal", 1, 0, 0, 1), game("equal", 1, 1, 4, 0)};
  const Row row = summarise(example_header(), games).rows[0];
  EXPECT_EQ(row.difference.count, 2);
  EXPECT_DOUBLE_EQ(row.difference.mean, 1.5);
  EXPECT_DOUBLE_EQ(row.difference.standard_error, 0);
  EXPECT_GT(row.a.goals.standard_error, 0);
}

TEST(Summary, LeavesIncompletePairsOut) {
  const std::vector<record::Attempt> games = {game("equal", 0, 0, 3, 0)};
  EXPECT_EQ(summarise(example_header(), games).rows[0].games, 0);
}

TEST(Summary, CountsAForfeitAsLostAndTellsWithoutIt) {
  const std::vector<record::Attempt> games = {forfeit_by_a(game("equal", 0, 0, 5, 0)),
                                              game("equal", 0, 1, 1, 0), game("equal", 1, 0, 1, 0),
                                              game("equal", 1, 1, 1, 0)};
  const Summary summary = summarise(example_header(), games);
  const Row& with = summary.rows[0];
  EXPECT_EQ(with.games, 4);
  EXPECT_EQ(with.a.wins, 3);
  EXPECT_EQ(with.b.wins, 1);
  EXPECT_EQ(with.a.forfeits, 1);
  EXPECT_DOUBLE_EQ(with.b.goals.mean, 3.0 / 4);
  EXPECT_DOUBLE_EQ(with.a.fouls, 4) << "per game played to its end";
  ASSERT_EQ(summary.without_forfeits.size(), 2U);
  EXPECT_EQ(summary.without_forfeits[0].games, 2) << "its partner goes too";
  EXPECT_EQ(summary.without_forfeits[0].a.wins, 2);
}

TEST(Summary, HasNoSecondTableWithoutForfeits) {
  const std::vector<record::Attempt> games = {game("equal", 0, 0, 3, 0), game("equal", 0, 1, 0, 0)};
  EXPECT_TRUE(summarise(example_header(), games).without_forfeits.empty());
}

TEST(Summary, CountsOnlyTheLastAttemptOfAPairWithVoidGames) {
  record::Attempt again = game("equal", 0, 0, 0, 1);
  record::Attempt partner = game("equal", 0, 1, 0, 1);
  again.attempt = partner.attempt = 2;
  const std::vector<record::Attempt> games = {game("equal", 0, 0, 9, 0), spoilt(game("equal", 0, 1, 0, 0)),
                                              again, partner};
  const Row row = summarise(example_header(), games).rows[0];
  EXPECT_EQ(row.games, 2);
  EXPECT_EQ(row.a.wins, 0);
  EXPECT_EQ(row.void_attempts, 1);
}

TEST(Summary, TellsOfPairsThatWereGivenUp) {
  std::vector<record::Attempt> games;
  for (int attempt = 1; attempt <= record::max_attempts; ++attempt) {
    games.push_back(spoilt(game("equal", 0, 0, 0, 0)));
    games.back().attempt = attempt;
  }
  EXPECT_EQ(summarise(example_header(), games).rows[0].given_up_pairs, 1);
}

TEST(Summary, CountsGamesThatAreCopies) {
  std::vector<record::Attempt> games = {game("equal", 0, 0, 1, 0), game("equal", 0, 1, 1, 0)};
  games[1].record.hash = games[0].record.hash;
  EXPECT_EQ(summarise(example_header(), games).repeated_games, 1);
}

// Pair means 1.5 and 1.5 from (3, 0) and (-1, 4): the legs move against each other,
// but two pairs say nothing.
TEST(Summary, TestsTheGoalDifferenceOverPairs) {
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 4; ++pair) {
    games.push_back(game("equal", pair, 0, pair, 0));  // 0 1 2 3
    games.push_back(game("equal", pair, 1, 3, pair));  // 3 2 1 0
  }
  const Row row = summarise(example_header(), games).rows[0];
  EXPECT_DOUBLE_EQ(row.difference.mean, 1.5);
  EXPECT_NEAR(row.correlation.value, -1, 1e-12);
  EXPECT_DOUBLE_EQ(row.permutation_p, 2.0 / 16);
  EXPECT_TRUE(std::isinf(row.bootstrap.low)) << "all pairs alike";
  EXPECT_FALSE(row.t_test.known);
}

TEST(Summary, AdjustsForTheConditionsThatHaveGames) {
  std::vector<record::Attempt> games;
  for (int pair = 0; pair < 3; ++pair) {
    for (int leg = 0; leg < 2; ++leg) games.push_back(game("equal", pair, leg, 1, 0));
  }
  EXPECT_FALSE(summarise(example_header(), games).rows[0].p_holm) << "one question";
  for (int pair = 0; pair < 3; ++pair) {
    for (int leg = 0; leg < 2; ++leg) games.push_back(game("hindered", pair, leg, 1, 1));
  }
  const std::vector<Row> rows = summarise(example_header(), games).rows;
  EXPECT_DOUBLE_EQ(rows[0].p_holm.value(), 2 * 2.0 / 64);
  EXPECT_DOUBLE_EQ(rows[1].p_holm.value(), 1);
}

TEST(Summary, TestsTheTrendOfASweepInsteadOfItsPoints) {
  const Summary summary = sweep_example();
  ASSERT_EQ(summary.sweeps.size(), 1U);
  EXPECT_EQ(summary.sweeps[0].key, "b.speed_factor");
  EXPECT_EQ(summary.sweeps[0].x, (std::vector<double>{0.3, 0.6, 0.3 + 0.3 * 2}));
  EXPECT_NEAR(summary.sweeps[0].trend.slope, -2 / 0.3, 1e-9);
  EXPECT_FALSE(summary.rows[0].p_holm);
}

TEST(Row, SaysPlainlyWhatIsShown) {
  Row row;
  EXPECT_EQ(row.verdict(), "no game counts yet");
  row.games = 20;
  row.p = 0.62;
  EXPECT_EQ(row.verdict(), "no difference shown (p = 0.620)");
  row.p = 0.003;
  row.a.wins = 15;
  row.b.wins = 2;
  row.permutation_p = 0.125;
  EXPECT_EQ(row.verdict(),
            "A wins more games than it loses (p = 0.003) if the games of a pair are independent; over pairs "
            "not shown (sign flips p 0.125)");
  EXPECT_FALSE(row.shows_difference());
  row.permutation_p = 0.004;
  EXPECT_TRUE(row.shows_difference());
  EXPECT_EQ(row.verdict(), "A wins more games than it loses (p = 0.003)");
  row.p_holm = 0.06;
  EXPECT_EQ(row.verdict(), "no difference shown (p = 0.003; Holm 0.060)");
  row.p_holm.reset();
  row.b.wins = 19;
  row.p = 1e-5;
  EXPECT_EQ(row.verdict(), "A loses more games than it wins (p < 0.001)");
}

}  // namespace
}  // namespace report
