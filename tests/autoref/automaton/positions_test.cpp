#include "autoref/automaton/positions.h"

#include <gtest/gtest.h>

namespace automaton {
namespace {

using world::Team;
using world::Vector2d;

const world::RuleSet& rules() { return world::rule_set("ssl-2015"); }

// Blue defends the goal at +x.
Vector2d free_kick(Team team, Vector2d place) {
  return free_kick_position(rules(), world::GameState{}, team, place);
}

void expect_near(const Vector2d& actual, const Vector2d& expected) {
  EXPECT_LT((actual - expected).norm(), 1e-9) << actual.transpose() << " instead of " << expected.transpose();
}

TEST(FreeKickPosition, IsThePlaceItselfInTheOpenField) {
  expect_near(free_kick(Team::Yellow, {1, -1}), {1, -1});
}

TEST(FreeKickPosition, IsAtLeastTenCentimetresInside) {
  expect_near(free_kick(Team::Yellow, {1, 3.3}), {1, 2.9});
}

TEST(FreeKickPosition, LeavesADefenseAreaTowardsTheTouchLine) {
  expect_near(free_kick(Team::Blue, {4.2, -0.3}), {3.9, -2.9});
  expect_near(free_kick(Team::Yellow, {-4.2, 0.3}), {-3.9, 2.9});
}

TEST(FreeKickPosition, KeepsAttackersSeventyCentimetresFromTheArea) {
  expect_near(free_kick(Team::Yellow, {3.4, 0}), {4.5 - 1.0 - 0.7, 0});
  expect_near(free_kick(Team::Blue, {3.4, 0}), {3.4, 0});  // its own area
}

// The four corners, both teams: always inside, always legal.
TEST(FreeKickPosition, IsLegalEverywhere) {
  for (double x = -5; x <= 5; x += 0.125) {
    for (double y = -3.5; y <= 3.5; y += 0.125) {
      for (const Team team : world::both_teams) {
        const Vector2d place = free_kick(team, {x, y});
        EXPECT_LE(world::distance_outside_lines(rules().field, place), -0.1 + 1e-9);
        const world::Side attacked = team == Team::Yellow ? world::Side::Positive : world::Side::Negative;
        EXPECT_GE(world::distance_to_defense_area(rules().field, attacked, place), 0.7 - 1e-9)
            << "(" << x << ", " << y << ") for " << world::name(team);
        EXPECT_GT(world::distance_to_defense_area(rules().field, world::other(attacked), place), 0);
        const Vector2d neutral = neutral_position(rules(), {x, y});
        EXPECT_LE(world::distance_outside_lines(rules().field, neutral), -0.1 + 1e-9);
        EXPECT_GE(world::distance_to_defense_area(rules().field, attacked, neutral), 0.7 - 1e-9);
      }
    }
  }
}

TEST(ExitPositions, AreThoseOfAlgorithm2) {
  expect_near(kick_in_position(rules(), {1.2, 3.0215}), {1.2, 2.9});
  expect_near(kick_in_position(rules(), {4.5, -3.0215}), {4.4, -2.9});
  expect_near(goal_line_position(rules(), {4.5215, -0.7}, true), {4.4, -2.9});
  expect_near(goal_line_position(rules(), {-4.5215, 0.7}, false), {-4.0, 2.9});
}

}  // namespace
}  // namespace automaton
