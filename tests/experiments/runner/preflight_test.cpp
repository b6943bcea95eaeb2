#include "experiments/runner/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/experiments/runner/support.h"

namespace runner {
namespace {

using testing::HasSubstr;

record::MatchRecord finished(const std::string& hash) {
  record::MatchRecord record;
  record.termination = record::Termination::Finished;
  record.at_fault = record::Party::Nobody;
  record.hash = hash;
  return record;
}

TEST(Preflight, PlaysEveryTwoProgramsOnce) {
  schedule::Design design = small_design(3);  // two conditions of the same programs
  EXPECT_EQ(preflight_games(design).size(), 1U);
  design.conditions[1].b.command = {"true", "--fast"};
  EXPECT_EQ(preflight_games(design).size(), 2U);
}

TEST(Preflight, IsShortAndNeedsNoWinner) {
  schedule::Design design = small_design(1);
  design.winner = true;
  const auto games = preflight_games(design);
  EXPECT_LE(*games[0].job.game.config.half_length, 15);
  EXPECT_FALSE(games[0].job.game.config.winner);
}

TEST(Preflight, JudgesTheRecords) {
  const schedule::Design design = small_design(1);
  PreflightGame game = preflight_games(design)[0];
  game.records = {finished("abc"), finished("abc")};
  EXPECT_FALSE(judged(game, design).failed);
  EXPECT_EQ(judged(game, design).sentence, "");

  game.records[1].hash = "def";
  EXPECT_FALSE(judged(game, design).failed) << "a team that is not deterministic may play";
  EXPECT_THAT(judged(game, design).sentence, HasSubstr("not deterministic"));

  game.records[1].termination = record::Termination::StoodStill;
  game.records[1].at_fault = record::Party::Yellow;
  game.records[1].reason = "yellow (A) never told a robot to move";
  EXPECT_TRUE(judged(game, design).failed);
  EXPECT_THAT(judged(game, design).sentence, HasSubstr("yellow (A) never told"));
}

TEST(Preflight, CountsTheGamesOfEveryTwoPrograms) {
  schedule::Design design = small_design(3);
  EXPECT_EQ(preflight_games(design)[0].games, 12);
  design.conditions[1].b.command = {"true", "--fast"};
  EXPECT_EQ(preflight_games(design)[0].games, 6);
  EXPECT_EQ(preflight_games(design)[1].games, 6);
}

// 5400 ticks of 49 ms; a full game has 73,728.
TEST(Preflight, ATeamThatWouldForfeitEveryGameFails) {
  const schedule::Design design = small_design(1);
  PreflightGame game = preflight_games(design)[0];
  record::MatchRecord record = finished("abc");
  record.ticks = 5400;
  record.wall_seconds = 266;
  record.costs["own_seconds_yellow"] = 264.6;
  game.records = {record, record};
  EXPECT_TRUE(judged(game, design).failed);
  EXPECT_EQ(judged(game, design).sentence,
            "condition 'equal': team 'theirs' takes 49 ms of its own time a tick, that is 3613 s for a full "
            "game, and 1440 s are allowed (limits.team_game): it would lose every game by forfeit");
}

}  // namespace
}  // namespace runner
