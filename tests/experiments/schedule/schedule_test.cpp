#include "experiments/schedule/schedule.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

namespace schedule {
namespace {

Design two_conditions(int pairs) {
  Design design;
  design.name = "test";
  design.seed = 7;
  design.pairs = pairs;
  const record::TeamConfig a{.name = "ours", .command = {"team-a"}};
  const record::TeamConfig b{.name = "theirs", .command = {"team-b"}};
  record::TeamConfig slow = b;
  slow.speed_factor = 0.5;
  design.conditions = {{"equal", a, b}, {"slow", a, slow}};
  return design;
}

TEST(Schedule, HasTwoLegsOfEveryPairAndCondition) {
  const Design design = two_conditions(5);
  ASSERT_EQ(game_count(design), 20U);
  std::set<record::GameKey> keys;
  for (std::size_t i = 0; i < game_count(design); ++i) keys.insert(game(design, i).key);
  EXPECT_EQ(keys.size(), 20U);
}

TEST(Schedule, GoesPairByPairSoThatConditionsStayLevel) {
  const Design design = two_conditions(5);
  EXPECT_EQ(record::game_id(game(design, 0).key), "equal-0000-0");
  EXPECT_EQ(record::game_id(game(design, 1).key), "equal-0000-1");
  EXPECT_EQ(record::game_id(game(design, 2).key), "slow-0000-0");
  EXPECT_EQ(record::game_id(game(design, 4).key), "equal-0001-0");
}

TEST(Schedule, SharesSeedsBetweenConditionsAndNowhereElse) {
  const Design design = two_conditions(10);
  std::map<std::pair<int, int>, std::set<std::uint64_t>> seeds;
  std::set<std::uint64_t> all;
  for (std::size_t i = 0; i < game_count(design); ++i) {
    const Game one = game(design, i);
    seeds[{one.key.pair, one.key.leg}].insert(one.config.seed);
    all.insert(one.config.seed);
  }
  for (const auto& [key, values] : seeds) EXPECT_EQ(values.size(), 1U);
  EXPECT_EQ(all.size(), 20U);
}

TEST(Schedule, TakesItsSeedsFromTheDesigns) {
  Design design = two_conditions(1);
  const std::uint64_t before = game(design, 0).config.seed;
  design.seed = 8;
  EXPECT_NE(game(design, 0).config.seed, before);
}

TEST(Schedule, ExchangesTheColoursBetweenTheLegs) {
  const Design design = two_conditions(2);
  const Game first = game(design, 2);
  const Game second = game(design, 3);
  EXPECT_EQ(first.a_colour, world::Team::Blue);
  EXPECT_EQ(second.a_colour, world::Team::Yellow);
  EXPECT_EQ(first.config.teams.blue.name, "ours");
  EXPECT_EQ(first.config.teams.yellow.speed_factor, 0.5);
  EXPECT_EQ(second.config.teams.blue.speed_factor, 0.5);
  EXPECT_EQ(second.config.teams.yellow.name, "ours");
}

TEST(Schedule, ChoosesEndsAndFirstKickoffByTwoBitsOfThePairEqualInBothLegs) {
  const Design design = two_conditions(4);
  std::set<std::pair<bool, world::Team>> seen;
  for (std::size_t pair = 0; pair < 4; ++pair) {
    const Game first = game(design, 4 * pair);
    const Game second = game(design, 4 * pair + 1);
    EXPECT_EQ(first.config.blue_on_positive_half, second.config.blue_on_positive_half);
    EXPECT_EQ(first.config.first_kickoff, second.config.first_kickoff);
    seen.insert({first.config.blue_on_positive_half, first.config.first_kickoff});
  }
  EXPECT_EQ(seen.size(), 4U);
}

TEST(Schedule, FindsAGameByItsName) {
  const Design design = two_conditions(3);
  EXPECT_EQ(find_game(design, "slow-0002-1").key, (record::GameKey{"slow", 2, 1}));
  EXPECT_THROW(find_game(design, "slow-0003-0"), std::invalid_argument);
  EXPECT_THROW(find_game(design, ""), std::invalid_argument);
}

}  // namespace
}  // namespace schedule
