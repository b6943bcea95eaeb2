// One call of the system for each message each way: two for each team's tick and two for its reply.

#include <gtest/gtest.h>

#include "tests/bench/game.h"

namespace hot {
namespace {

TEST(Tick, CallsTheSystemOnceForEachMessageEachWay) {
  Game game(plain_team());
  game.play_to(5);
  EXPECT_EQ(game.host_calls(), 4 * game.engine().tick());  // to and from each team
  EXPECT_EQ(game.team_calls(), 4 * game.engine().tick());  // both teams: in and out
}

}  // namespace
}  // namespace hot
