#include "experiments/runner/pace.h"

#include <gtest/gtest.h>

#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

/// 5400 ticks, of which the teams take so much [ms].
record::MatchRecord short_game(double tick, double yellow, double blue) {
  record::MatchRecord record;
  record.ticks = 5400;
  record.wall_seconds = 5.4 * tick;
  record.costs = {{"own_seconds_yellow", 5.4 * yellow}, {"own_seconds_blue", 5.4 * blue}};
  return record;
}
record::MatchConfig config() {
  record::MatchConfig config;
  config.teams.yellow.name = "snail";
  config.teams.blue.name = "hare";
  return config;
}

TEST(Pace, IsTheMeanOfAllTicks) {
  const Pace pace = pace_of(config(), {short_game(2, 1, 0.5), short_game(4, 3, 0.5)}, 10);
  EXPECT_NEAR(pace.tick, 0.003, 1e-12);
  EXPECT_NEAR(pace.own.yellow, 0.002, 1e-12);
  EXPECT_NEAR(pace.own.blue, 0.0005, 1e-12);
  EXPECT_EQ(pace_of(config(), {}, 10).tick, 0);
}

// Two halves of 600 s and what goes on after them: 73,728 ticks of 10 ms.
TEST(Pace, SaysHowLongAllGamesTake) {
  schedule::Design design = small_design(1);
  EXPECT_NEAR(full_game_ticks(design), 73'728, 1);
  const Pace pace = pace_of(config(), {short_game(10, 9, 0.5)}, 4);
  EXPECT_NEAR(expected_seconds(design, {pace}, 2), 4 * 737.28 / 2, 0.1);
}

TEST(Pace, NamesATeamThatWouldUseUpItsBudget) {
  schedule::Design design = small_design(1);
  EXPECT_EQ(budget_problem(design, pace_of(config(), {short_game(20, 19, 0.5)}, 4)), "") << "1401 s of 1440";
  EXPECT_EQ(budget_problem(design, pace_of(config(), {short_game(25, 24, 0.5)}, 4)),
            "team 'snail' takes 24 ms of its own time a tick, that is 1769 s for a full game, and 1440 s are "
            "allowed (limits.team_game): it would lose every game by forfeit");
  EXPECT_EQ(
      budget_problem(design, pace_of(config(), {short_game(1100, 0.5, 1099)}, 4)),
      "team 'hare' takes 1099 ms of its own time a tick, that is 65.9 s for a simulated second, and 20 s "
      "are allowed (limits.team_second): it would lose every game by forfeit");
}

// 400 games of 737 s, two at a time: 41 h.
TEST(Pace, NamesTheTeamThatMakesANightTooLong) {
  schedule::Design design = small_design(100);
  const std::vector<Pace> paces = {pace_of(config(), {short_game(10, 9, 0.5)}, 400)};
  EXPECT_EQ(slowest_team(design, paces, 2),
            "the games take longer than a night of 10 h: team 'snail' takes 9 ms of its own time a tick of "
            "10 ms in "
            "all; with it the 400 games take 41 h");
  EXPECT_EQ(slowest_team(design, paces, 20), "") << "4 h";
  EXPECT_EQ(slowest_team(design, {pace_of(config(), {short_game(10, 1, 0.5)}, 400)}, 2), "")
      << "no team's doing";
  EXPECT_EQ(slowest_team(design, {}, 2), "");
}

}  // namespace
}  // namespace runner
