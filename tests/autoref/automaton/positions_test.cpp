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

// --- Properties, over a grid that covers the run-off, on three fields, for both teams ---

world::RuleSet on_field(double length, double width, bool rectangle) {
  world::RuleSet with = rules();
  with.field.length = length;
  with.field.width = width;
  if (rectangle) {
    with.field.defense_area = {.shape = world::DefenseArea::Shape::Rectangle, .depth = 1.8, .width = 3.6};
  }
  return with;
}

// The laws' field, that of RoboCup 2014 (R-R15-16), and a division A field of today.
std::vector<world::RuleSet> fields() {
  return {on_field(9, 6, false), on_field(8.09, 6.05, false), on_field(12, 9, true)};
}

// Calls check(rules, team, place) on a grid of 0.11 m, which no line or area of the fields is a multiple of.
template <class Check>
void everywhere(Check check) {
  for (const world::RuleSet& with : fields()) {
    for (double x = -with.field.half_length() - 0.505; x < with.field.half_length() + 0.6; x += 0.11) {
      for (double y = -with.field.half_width() - 0.505; y < with.field.half_width() + 0.6; y += 0.11) {
        for (const Team team : world::both_teams) check(with, team, Vector2d(x, y));
      }
    }
  }
}

constexpr double rounding = 1e-9;  // [m] of a few additions and square roots of metres

TEST(FreeKickPosition, IsLegalEverywhere) {
  everywhere([](const world::RuleSet& with, Team team, const Vector2d& place) {
    const world::Side attacked = team == Team::Yellow ? world::Side::Positive : world::Side::Negative;
    const Vector2d kick = free_kick_position(with, world::GameState{}, team, place);
    EXPECT_LE(world::distance_outside_lines(with.field, kick), -0.1 + rounding) << place.transpose();
    EXPECT_GE(world::distance_to_defense_area(with.field, attacked, kick), 0.7 - rounding)
        << place.transpose() << " for " << world::name(team);
    EXPECT_GT(world::distance_to_defense_area(with.field, world::other(attacked), kick), 0);
    const Vector2d neutral = neutral_position(with, place);
    EXPECT_LE(world::distance_outside_lines(with.field, neutral), -0.1 + rounding) << place.transpose();
    for (const world::Side side : {world::Side::Negative, world::Side::Positive}) {
      EXPECT_GE(world::distance_to_defense_area(with.field, side, neutral), 0.7 - rounding)
          << place.transpose();
    }
  });
}

TEST(FreeKickPosition, IsTheSameWhenDueThere) {
  everywhere([](const world::RuleSet& with, Team team, const Vector2d& place) {
    const world::GameState state;
    const Vector2d kick = free_kick_position(with, state, team, place);
    EXPECT_LT((free_kick_position(with, state, team, kick) - kick).norm(), rounding) << place.transpose();
    const Vector2d neutral = neutral_position(with, place);
    EXPECT_LT((neutral_position(with, neutral) - neutral).norm(), rounding) << place.transpose();
  });
}

TEST(FreeKickPosition, IsMirroredWithTheFieldAndTheColours) {
  everywhere([](const world::RuleSet& with, Team team, const Vector2d& place) {
    const world::GameState state;
    world::GameState changed;
    changed.blue_on_positive_half = !state.blue_on_positive_half;
    const Vector2d kick = free_kick_position(with, state, team, place);
    const Vector2d mirror_x(-place.x(), place.y());
    const Vector2d mirror_y(place.x(), -place.y());
    expect_near(free_kick_position(with, state, world::opponent(team), mirror_x), {-kick.x(), kick.y()});
    expect_near(free_kick_position(with, changed, team, mirror_x), {-kick.x(), kick.y()});
    expect_near(free_kick_position(with, state, team, mirror_y), {kick.x(), -kick.y()});
    const Vector2d neutral = neutral_position(with, place);
    expect_near(neutral_position(with, mirror_x), {-neutral.x(), neutral.y()});
    expect_near(neutral_position(with, mirror_y), {neutral.x(), -neutral.y()});
  });
}

// Where nothing forbids it, the kick is taken where it is due; and it is never moved further than it must be.
TEST(FreeKickPosition, IsTheNearestLegalPoint) {
  everywhere([](const world::RuleSet& with, Team team, const Vector2d& place) {
    const world::Side attacked = team == Team::Yellow ? world::Side::Positive : world::Side::Negative;
    const Vector2d kick = free_kick_position(with, world::GameState{}, team, place);
    const double from_attacked = world::distance_to_defense_area(with.field, attacked, place);
    const double from_own = world::distance_to_defense_area(with.field, world::other(attacked), place);
    if (std::min(from_attacked, from_own) <= 0) return;  // then it is the point at the touch line
    const double outside = world::distance_outside_lines(with.field, place) + 0.1;
    if (outside <= 0 && from_attacked >= 0.7) {
      expect_near(kick, place);
    } else if (outside <= 0) {
      // Straight out of the area; only beside a goal line the lines leave less room than that.
      const double moved = (kick - place).norm();
      EXPECT_GE(moved, 0.7 - from_attacked - rounding);
      if (std::abs(kick.x()) < with.field.half_length() - 0.1 - rounding) {
        EXPECT_NEAR(moved, 0.7 - from_attacked, 1e-6) << place.transpose();
      }
    }
  });
}

// R-R15-3 in the four corners, written out.
TEST(FreeKickPosition, InsideAnAreaIsTheNearerPointAtTheTouchLine) {
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const Team team : world::both_teams) {
        expect_near(free_kick(team, {x * 4.3, y * 0.2}), {x * 3.9, y * 2.9});
        expect_near(free_kick(team, {x * 4.49, y * 1.2}), {x * 3.9, y * 2.9});
        expect_near(free_kick(team, {x * 5.0, y * 3.4}), {x * 4.4, y * 2.9});  // the corner itself
      }
    }
  }
}

TEST(ExitPositions, AreThoseOfAlgorithm2) {
  expect_near(kick_in_position(rules(), {1.2, 3.0215}), {1.2, 2.9});
  expect_near(kick_in_position(rules(), {4.5, -3.0215}), {4.4, -2.9});
  expect_near(goal_line_position(rules(), {4.5215, -0.7}, true), {4.4, -2.9});
  expect_near(goal_line_position(rules(), {-4.5215, 0.7}, false), {-4.0, 2.9});
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      expect_near(goal_line_position(rules(), {x * 4.5215, y * 2.0}, true), {x * 4.4, y * 2.9});
      expect_near(goal_line_position(rules(), {x * 4.5215, y * 2.0}, false), {x * 4.0, y * 2.9});
    }
  }
}

// Exits lead to legal places, and to places that a free kick due there would not leave.
TEST(ExitPositions, AreLegalForBothTeams) {
  for (const world::RuleSet& with : fields()) {
    const Vector2d half(with.field.half_length(), with.field.half_width());
    std::vector<Vector2d> places;
    for (double share = -0.99; share < 1; share += 0.06) {
      for (const double side : {-1.0, 1.0}) {
        places.push_back(kick_in_position(with, {share * half.x(), side * (half.y() + 0.0215)}));
        for (const bool corner : {false, true}) {
          places.push_back(goal_line_position(with, {side * (half.x() + 0.0215), share * half.y()}, corner));
        }
      }
    }
    for (const Vector2d& place : places) {
      for (const Team team : world::both_teams) {
        expect_near(free_kick_position(with, world::GameState{}, team, place), place);
      }
    }
  }
}

TEST(PenaltyMark, IsInFrontOfTheDefendersGoal) {
  world::GameState state;
  expect_near(penalty_mark(rules(), state, Team::Blue), {3.5, 0});
  expect_near(penalty_mark(rules(), state, Team::Yellow), {-3.5, 0});
  state.blue_on_positive_half = false;
  expect_near(penalty_mark(rules(), state, Team::Blue), {-3.5, 0});
}

}  // namespace
}  // namespace automaton
