#include "experiments/report/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/experiments/report/examples.h"

namespace report {
namespace {

const Comparison& named(const std::vector<Comparison>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Comparison& one) { return one.name == name; });
}

bool has(const std::vector<Comparison>& all, const std::string& name) {
  return std::any_of(all.begin(), all.end(), [&](const Comparison& one) { return one.name == name; });
}

class CompareTest : public testing::Test {
 protected:
  void add(int pair, int shots) {
    for (int leg = 0; leg < 2; ++leg)
      games_.push_back(with_statistics(game("equal", pair, leg, 1, 0), shots + leg));
  }
  std::vector<Pair> pairs() const {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i + 1 < games_.size(); i += 2) pairs.push_back({&games_[i], &games_[i + 1]});
    return pairs;
  }
  std::vector<record::Attempt> games_;
};

// Pairs of 4 5, 6 7, 8 9 shots against 2 always: differences over pairs 2.5, 4.5, 6.5.
TEST_F(CompareTest, ComparesAWithBOverPairsWhateverItsColour) {
  for (int pair = 0; pair < 3; ++pair) add(pair, 4 + 2 * pair);
  const Comparison shots = named(compare(pairs()), "shots");
  EXPECT_DOUBLE_EQ(shots.a.mean, 6.5);
  EXPECT_EQ(shots.a.count, 6);
  EXPECT_DOUBLE_EQ(shots.b.mean, 2);
  EXPECT_DOUBLE_EQ(shots.test.difference, 4.5);
  EXPECT_NEAR(shots.test.standard_error, 2 / std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(shots.test.t, 4.5 * std::sqrt(3.0) / 2, 1e-12);
}

TEST_F(CompareTest, LeavesOutWhatAGameSaysNothingAbout) {
  add(0, 4);
  // B never passes in the example, so its completion is unknown and cannot be compared.
  EXPECT_FALSE(has(compare(pairs()), "pass_completion"));
  EXPECT_TRUE(has(compare(pairs()), "passes"));
  EXPECT_FALSE(has(compare(pairs()), "territory")) << "nobody was anywhere";
}

TEST_F(CompareTest, LeavesOutForfeitsAndGamesWithoutStatistics) {
  add(0, 4);
  add(1, 40);
  add(2, 400);
  games_[3] = forfeit_by_a(games_[3]);
  games_[4].record.statistics.reset();
  EXPECT_DOUBLE_EQ(named(compare(pairs()), "shots").a.mean, 4.5);
}

TEST_F(CompareTest, CountsOffencesByKind) {
  add(0, 4);
  const std::vector<Comparison> found = compare(pairs());
  EXPECT_DOUBLE_EQ(named(found, "foul_AimlessKick").a.mean, 1);
  EXPECT_DOUBLE_EQ(named(found, "foul_AimlessKick").b.mean, 0);
  EXPECT_DOUBLE_EQ(named(found, "fouls").b.mean, 7);
}

TEST_F(CompareTest, AdjustsForTheNumberOfStatistics) {
  for (int pair = 0; pair < 3; ++pair) add(pair, 4 + 2 * pair);
  const std::vector<Comparison> found = compare(pairs());
  const Comparison shots = named(found, "shots");
  EXPECT_GE(shots.p_holm, shots.test.p);
  EXPECT_LE(shots.p_holm, 1);
}

TEST_F(CompareTest, FindsNothingWithoutStatistics) {
  EXPECT_TRUE(compare({}).empty());
  EXPECT_TRUE(game_numbers({}).empty());
}

TEST_F(CompareTest, GivesTheNumbersOfTheGame) {
  add(0, 4);
  const std::vector<GameNumber> found = game_numbers(pairs());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].name, "ball_in_play");
  EXPECT_DOUBLE_EQ(found[0].value.mean, 50);
}

}  // namespace
}  // namespace report
