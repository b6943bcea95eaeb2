// Whole short games: who looks on changes nothing, and remade eyes see what the referee saw.
#include "experiments/judge/game.h"

#include <gtest/gtest.h>

#include "experiments/judge/game_file.h"
#include "tests/experiments/runner/support.h"
#include "tests/fakes/games.h"

namespace judge {
namespace {

TEST(PlayJudged, ChangesNothingAndRemakesTheRefereesOwnEyes) {
  record::MatchConfig config = fakes::short_game("wander", "wander");
  config.half_length = 30;
  const record::MatchRecord alone = host::play(config);
  ASSERT_EQ(alone.termination, record::Termination::Finished) << alone.reason;

  // The first shadow has cameras, filter and touch detection of its own, with the game's numbers;
  // the second sees worse.
  const GameResult judged =
      play_judged({"it", config, {parse_shadow("vision.delay=1"), parse_shadow("vision.ball_sigma=0.005")}});
  EXPECT_EQ(judged.hash, alone.hash);
  EXPECT_EQ(judged.ticks, alone.ticks);

  std::vector<std::string> ours, remade, worse;
  for (Case one : judged.cases) {
    auto& list = one.shadow == acting_name ? ours : one.shadow == "vision.delay=1" ? remade : worse;
    one.shadow.clear();
    if (one.call) one.call->witnesses.clear();
    GameResult single;
    single.cases = {one};
    list.push_back(to_json(single));
  }
  EXPECT_FALSE(ours.empty());
  EXPECT_EQ(ours, remade);
  EXPECT_NE(ours, worse);
}

class RecordedGame : public ::testing::Test {
 protected:
  RecordedGame() {
    job_.game = "it";
    job_.config = fakes::short_game("wander", "wander");
    job_.config.half_length = 5;
    job_.config.realism.preset = "harsh";  // lost images, false balls
    job_.keep = folder_.path() / "it.judged";
  }
  runner::TemporaryFolder folder_;
  Job job_;
};

TEST_F(RecordedGame, GivesTheSameResultAgain) {
  job_.shadows = {parse_shadow("rules=paper")};
  const GameResult played = play_judged(job_);
  ASSERT_EQ(played.fault, "");
  ASSERT_FALSE(played.cases.empty());
  EXPECT_EQ(to_json(judge_again(job_.keep, job_.shadows)), to_json(played));
}

TEST_F(RecordedGame, CannotBeSeenByOtherCameras) {
  play_judged(job_);
  EXPECT_THROW(judge_again(job_.keep, {parse_shadow("vision.ball_sigma=0.002")}), std::invalid_argument);
}

// A file that stops anywhere, or is none, is one sentence that names it.
TEST_F(RecordedGame, IsNotBelievedWhenDamaged) {
  play_judged(job_);
  const auto size = std::filesystem::file_size(job_.keep);
  for (const std::uintmax_t left : {size - 1, size - 40, size / 2, std::uintmax_t{100}, std::uintmax_t{10}}) {
    std::filesystem::resize_file(job_.keep, left);
    try {
      judge_again(job_.keep, {});
      ADD_FAILURE() << "believed with " << left << " bytes";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("it.judged"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace judge
