#include "sim/world/game_state.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace world {
namespace {

TEST(Command, TheTeamCountsOnlyWhereTheCommandTakesOne) {
  EXPECT_TRUE((Command{CommandKind::Stop, Team::Blue} == Command{CommandKind::Stop, Team::Yellow}));
  EXPECT_FALSE((Command{CommandKind::Direct, Team::Blue} == Command{CommandKind::Direct, Team::Yellow}));
}

TEST(CommandKind, EachHasANameOfItsOwn) {
  std::set<std::string> names;
  for (int kind = 0; kind <= static_cast<int>(CommandKind::Timeout); ++kind) {
    names.insert(name(static_cast<CommandKind>(kind)));
  }
  EXPECT_EQ(names.size(), 10u);
  EXPECT_FALSE(names.contains("?"));
}

TEST(DefendedSide, TheTwoTeamsAlwaysDefendDifferentGoals) {
  for (const bool positive : {false, true}) {
    GameState state;
    state.blue_on_positive_half = positive;
    EXPECT_EQ(defended_side(state, Team::Blue), positive ? Side::Positive : Side::Negative);
    EXPECT_EQ(defended_side(state, Team::Yellow), other(defended_side(state, Team::Blue)));
    for (const Team team : both_teams) EXPECT_EQ(defending_team(state, defended_side(state, team)), team);
  }
}

}  // namespace
}  // namespace world
