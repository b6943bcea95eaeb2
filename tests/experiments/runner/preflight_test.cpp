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
  PreflightGame game = preflight_games(small_design(1))[0];
  game.records = {finished("abc"), finished("abc")};
  EXPECT_FALSE(judged(game).failed);
  EXPECT_EQ(judged(game).sentence, "");

  game.records[1].hash = "def";
  EXPECT_FALSE(judged(game).failed) << "a team that is not deterministic may play";
  EXPECT_THAT(judged(game).sentence, HasSubstr("not deterministic"));

  game.records[1].termination = record::Termination::Implausible;
  game.records[1].at_fault = record::Party::Harness;
  game.records[1].reason = "this was no game: yellow never told a robot to move";
  EXPECT_TRUE(judged(game).failed);
  EXPECT_THAT(judged(game).sentence, HasSubstr("yellow never told"));
}

}  // namespace
}  // namespace runner
