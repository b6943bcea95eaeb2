#include "autoref/automaton/stages.h"

#include <gtest/gtest.h>

#include <set>

namespace automaton {
namespace {

using namespace std::chrono_literals;
using enum world::Stage;
using world::Stage;
using world::Team;

world::RuleSet with_winner() {
  world::RuleSet rules = world::rule_set("ssl-2015");
  rules.winner = true;
  return rules;
}

// R-6.2-3: the paper's chain of stages.
TEST(Stages, FollowTheChainOfTable5) {
  const world::RuleSet& rules = world::rule_set("ssl-2015");
  for (const bool draw : {false, true}) {
    Stage stage = PreFirst;
    for (const Stage next : {First, HalfTime, PreSecond, Second, Post, Post}) {
      stage = next_stage(rules, stage, draw);
      EXPECT_EQ(stage, next);
    }
  }
}

TEST(Stages, GoThroughExtraTimeAndAShootoutWhenAWinnerIsWanted) {
  Stage stage = Second;
  for (const Stage next : {ExtraBreak, PreExtraFirst, ExtraFirst, ExtraHalfTime, PreExtraSecond, ExtraSecond,
                           ShootoutBreak, Shootout, Post}) {
    stage = next_stage(with_winner(), stage, true);
    EXPECT_EQ(stage, next);
  }
  EXPECT_EQ(next_stage(with_winner(), Second, false), Post);
  EXPECT_EQ(next_stage(with_winner(), ExtraSecond, false), Post);
}

// R-6.2-5, R-4.1-1.
TEST(Stages, HaveTheLengthsOfTheLaws) {
  const world::RuleSet rules = with_winner();
  EXPECT_EQ(stage_length(rules, First), 10min);
  EXPECT_EQ(stage_length(rules, Second), 10min);
  EXPECT_EQ(stage_length(rules, ExtraFirst), 5min);
  EXPECT_EQ(stage_length(rules, ExtraSecond), 5min);
  EXPECT_EQ(stage_length(rules, HalfTime), rules.half_time);
  for (const Stage open : {PreFirst, PreSecond, PreExtraFirst, PreExtraSecond, Shootout, Post}) {
    EXPECT_FALSE(stage_length(rules, open)) << world::name(open);
  }
}

// R-6.2-5: KICKOFF(T) for half-time, HALT for halves; T changes with the half (R-R15-13).
TEST(Stages, EndWithTheCommandsOfThePaper) {
  world::GameState state;
  state.first_kickoff = Team::Blue;
  const auto command = [&](Stage stage) {
    state.stage = stage;
    return stage_end_command(state);
  };
  using enum world::CommandKind;
  for (const Stage half : {First, Second, ExtraFirst, ExtraSecond}) {
    EXPECT_EQ(command(half), world::Command{Halt}) << world::name(half);
  }
  EXPECT_EQ(command(HalfTime), (world::Command{Kickoff, Team::Yellow}));
  EXPECT_EQ(command(ExtraBreak), (world::Command{Kickoff, Team::Blue}));
  EXPECT_EQ(command(ExtraHalfTime), (world::Command{Kickoff, Team::Yellow}));
  EXPECT_EQ(command(ShootoutBreak), world::Command{Stop});
  EXPECT_EQ(command(Shootout), world::Command{Halt});
}

// An independent statement of the rule: it is decided when every way to finish the five kicks each has the
// same winner, and after five kicks each when a round of one kick each was not equal.
bool decided_by_trying(int yellow_kicks, int yellow, int blue_kicks, int blue) {
  const int yellow_left = std::max(0, 5 - yellow_kicks);
  const int blue_left = std::max(0, 5 - blue_kicks);
  if (yellow_left + blue_left == 0) return yellow_kicks == blue_kicks && yellow != blue;
  std::set<int> outcomes;
  for (int y = 0; y <= yellow_left; ++y) {
    for (int b = 0; b <= blue_left; ++b) {
      const int difference = yellow + y - blue - b;
      outcomes.insert((difference > 0) - (difference < 0));
    }
  }
  return outcomes.size() == 1 && *outcomes.begin() != 0;
}

TEST(Shootout, IsDecidedWhenNobodyCanCatchUp) {
  world::GameState state;
  for (int first = 0; first <= 8; ++first) {
    for (const int second : {first - 1, first}) {
      if (second < 0) continue;
      for (int yellow = 0; yellow <= first; ++yellow) {
        for (int blue = 0; blue <= second; ++blue) {
          state.shootout_kicks = {first, second};
          state.shootout_goals = {yellow, blue};
          EXPECT_EQ(shootout_is_decided(world::rule_set("ssl-2015"), state),
                    decided_by_trying(first, yellow, second, blue))
              << yellow << " of " << first << ", " << blue << " of " << second;
        }
      }
    }
  }
}

TEST(Shootout, EndsWithoutAWinnerAfterTwentyKicksEach) {
  world::GameState state;
  for (int kicks = 5; kicks < 20; ++kicks) {
    state.shootout_kicks = {kicks, kicks};
    EXPECT_FALSE(shootout_is_over(world::rule_set("ssl-2015"), state)) << kicks;
    state.shootout_kicks = {kicks + 1, kicks};
    EXPECT_FALSE(shootout_is_over(world::rule_set("ssl-2015"), state)) << kicks;
  }
  state.shootout_kicks = {20, 20};
  EXPECT_TRUE(shootout_is_over(world::rule_set("ssl-2015"), state));
  EXPECT_FALSE(shootout_is_decided(world::rule_set("ssl-2015"), state));
}

}  // namespace
}  // namespace automaton
