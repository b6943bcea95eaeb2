#include "experiments/host/tally.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace host {
namespace {

using testing::ElementsAre;
using testing::Pair;

referee::Call call(world::GameEvent event, bool stops_play) {
  referee::Call result;
  result.time = event.time;
  result.row = "T11.7";
  result.event = std::move(event);
  result.command = world::Command{world::CommandKind::Stop};
  result.restart = "indirect free kick for blue";
  result.sentence = "why";
  result.stops_play = stops_play;
  return result;
}

TEST(Tally, CountsCallsFoulsAndWritesTheTimeline) {
  referee::Setup setup;
  const referee::Referee referee(setup);
  Tally tally;
  referee::Call fast = call({world::tick_time(5), world::BotKickedBallTooFast{}}, true);
  fast.offender = world::RobotId{world::Team::Blue, 3};
  const referee::Call settled = call({world::tick_time(9), world::RobotsSettled{}}, false);
  referee::Call noted = call({world::tick_time(9), world::BotTooNearInStop{}}, false);
  noted.row = "note";
  noted.offender = world::RobotId{world::Team::Blue, 3};
  const std::vector<referee::Call> calls = {fast, fast, settled, noted};
  referee::Output output;
  output.calls = calls;
  EXPECT_EQ(tally.add(output, referee).size(), 4U);
  output.calls = {};
  EXPECT_TRUE(tally.add(output, referee).empty());

  record::MatchRecord record;
  tally.finish(referee, record);
  EXPECT_THAT(record.calls, ElementsAre(Pair("BotKickedBallTooFast", 2)));
  EXPECT_EQ(record.fouls, (world::PerTeam<int>{.yellow = 0, .blue = 2}));
  EXPECT_THAT(record.fouls_by_kind.blue, ElementsAre(Pair("BotKickedBallTooFast", 2)));
  EXPECT_TRUE(record.fouls_by_kind.yellow.empty());
  EXPECT_EQ(record.counters["noted_BotTooNearInStop"], 1);  // and no foul that was called
  EXPECT_DOUBLE_EQ(record.counters["simulated_seconds"], 2 * world::tick_length);
  ASSERT_EQ(record.timeline.size(), 4U);
  EXPECT_EQ(record.timeline[0], (record::CallEntry{world::tick_time(5), "T11.7", "BotKickedBallTooFast",
                                                   "STOP", "indirect free kick for blue", "why"}));
}

}  // namespace
}  // namespace host
