// The log of a game, refereed again from what is in the file alone, gives the calls the
// embedded referee gave.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "autoref/referee/referee.h"
#include "autoref/tracker/frame_grouper.h"
#include "experiments/host/play.h"
#include "experiments/host/tally.h"
#include "sim/wire/log_messages.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"
#include "tests/fakes/games.h"
#include "tests/fakes/programs.h"

namespace {

struct Replayed {
  std::vector<record::CallEntry> calls;
  world::PerTeam<int> score;
  int detections = 0;
  int referee_messages = 0;
};

// As the embedded one in everything that the log's first messages tell.
referee::Setup setup_of(const world::Geometry& geometry, const wire::proto::Referee& first) {
  referee::Setup setup = referee::parse_setup(first.status_message());
  setup.geometry = geometry;
  const auto message = wire::decode(first, wire::Epoch{});
  EXPECT_TRUE(message);
  setup.blue_on_positive_half = message->blue_on_positive_half;
  for (const world::Team team : world::both_teams) {
    setup.keeper[team] = message->teams[team].keeper;
    setup.names[team] = message->teams[team].name;
  }
  return setup;
}

Replayed replay(const std::filesystem::path& log) {
  Replayed result;
  wire::LogReader reader(log);
  wire::LogRecord record;
  wire::proto::SSL_WrapperPacket packet;
  wire::proto::Referee message;
  std::optional<world::Geometry> geometry;
  std::optional<referee::Referee> referee;
  tracker::FrameGrouper grouper;
  host::Tally tally;
  const auto judge = [&](std::span<const world::Detection> batch) {
    if (!batch.empty()) tally.add(referee->update(batch), *referee);
  };
  while (reader.next(record)) {
    if (wire::read(record, packet)) {
      if (packet.has_geometry()) geometry = wire::decode(packet.geometry());
      if (!packet.has_detection()) continue;
      ++result.detections;
      judge(grouper.add(wire::decode(packet.detection(), wire::Epoch{})));
    } else if (wire::read(record, message)) {
      ++result.referee_messages;
      if (!referee) {
        EXPECT_EQ(message.source_identifier(), "matchday");
        referee.emplace(setup_of(geometry.value(), message));
      }
    }
  }
  EXPECT_FALSE(reader.truncated());
  judge(grouper.flush());

  record::MatchRecord tallied;
  tally.finish(*referee, tallied);
  result.calls = tallied.timeline;
  result.score = tallied.goals;
  return result;
}

class ReplayTest : public testing::TestWithParam<const char*> {
 protected:
  ReplayTest()
      : folder_(std::filesystem::path(testing::TempDir()) / ("replay_test_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ReplayTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_;
};

TEST_P(ReplayTest, GivesTheSameCallsAtTheSameTimes) {
  auto config = fakes::short_game("wander", "wander");
  for (const world::Team team : world::both_teams)
    config.teams[team].command = {fakes::bin_dir() + "/team-chaser"};
  config.teams.blue.robots = {1, 2, 4};
  config.half_length = 20;
  config.realism.preset = GetParam();
  config.blue_on_positive_half = false;
  config.first_kickoff = world::Team::Blue;
  config.log = folder_ / "game.log.gz";
  const auto record = host::play(config);
  ASSERT_EQ(record.termination, record::Termination::Finished) << record.reason;

  const Replayed again = replay(*config.log);
  EXPECT_EQ(again.calls, record.timeline);
  EXPECT_GT(again.calls.size(), 4U);  // at least a start and an end of both halves
  EXPECT_EQ(again.score, record.goals);
  // Four cameras a tick, but for the ticks of the vision delay; referee messages at least ten times a second.
  EXPECT_NEAR(again.detections, 4 * static_cast<double>(record.ticks), 4);
  EXPECT_GE(again.referee_messages, record.ticks / 6);
  EXPECT_LT(again.referee_messages, record.ticks / 2);
}

INSTANTIATE_TEST_SUITE_P(Realism, ReplayTest, testing::Values("none", "measured", "harsh"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
