// Whole short games: who looks on changes nothing, and remade eyes see what the referee saw.
#include "experiments/judge/game.h"

#include <gtest/gtest.h>

#include "experiments/judge/game_file.h"
#include "tests/fakes/games.h"

namespace judge {
namespace {

TEST(PlayJudged, ChangesNothingAndRemakesTheRefereesOwnEyes) {
  record::MatchConfig config = fakes::short_game("wander", "wander");
  config.half_length = 30;
  const record::MatchRecord alone = host::play(config);
  ASSERT_EQ(alone.termination, record::Termination::Finished) << alone.reason;

  // The first shadow has cameras, filter and touch detection of its own, with the game's numbers; the second
  // sees worse.
  const GameResult judged =
      play_judged("it", config, {parse_shadow("vision.delay=1"), parse_shadow("vision.ball_sigma=0.005")});
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

}  // namespace
}  // namespace judge
