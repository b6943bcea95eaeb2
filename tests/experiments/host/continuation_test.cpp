// Recorded games: again to their end, and on from any moment with teams that start anew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "experiments/host/play.h"
#include "experiments/host/recorded_teams.h"
#include "tests/fakes/games.h"

namespace host {
namespace {

using record::Continuation;
using record::MatchConfig;
using record::Termination;
using testing::HasSubstr;

class RecordedGame : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory = std::filesystem::temp_directory_path() / ("recorded-game-" + std::to_string(::getpid()));
    std::filesystem::create_directories(directory);
    config = fakes::short_game("wander", "wander");
    config.recording = directory / "game.replies";
    original = play(config);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(directory); }

  static MatchConfig continued(std::optional<std::int64_t> tick) {
    MatchConfig again = recorded_config(*config.recording);
    again.recording.reset();
    again.continuation = Continuation{*config.recording, tick};
    return again;
  }

  inline static std::filesystem::path directory;
  inline static MatchConfig config;
  inline static record::MatchRecord original;
};

TEST_F(RecordedGame, KnowsItsConfiguration) { EXPECT_EQ(recorded_config(*config.recording), config); }

TEST_F(RecordedGame, GoesTheSameWayWithoutItsTeams) {
  MatchConfig again = continued(std::nullopt);
  again.teams.yellow.command = {"/nowhere/no-team"};
  const record::MatchRecord record = play(again);
  ASSERT_EQ(original.termination, Termination::Finished) << original.reason;
  EXPECT_EQ(record.termination, Termination::Finished) << record.reason;
  EXPECT_EQ(record.hash, original.hash);
  EXPECT_EQ(record.timeline, original.timeline);
  EXPECT_EQ(record.versions, original.versions);
}

TEST_F(RecordedGame, ThatEndedByAFaultGoesTheSameWayUpToIt) {
  MatchConfig faulty = config;
  faulty.recording = directory / "faulty.replies";
  faulty.teams.blue.command = fakes::fake_team("crash", 433);
  const record::MatchRecord crashed = play(faulty);
  ASSERT_EQ(crashed.termination, Termination::Crashed);
  MatchConfig again = recorded_config(*faulty.recording);
  again.recording.reset();
  again.continuation = Continuation{*faulty.recording, std::nullopt};
  Options options;
  options.last_tick = crashed.ticks;
  const record::MatchRecord record = play(again, options);
  EXPECT_EQ(record.ticks, 433);
  EXPECT_EQ(record.hash, crashed.hash);
  EXPECT_EQ(record.reason, "the game was broken off after tick 433");
}

// The moments: before the first second, in the middle of a second, in the second half.
TEST_F(RecordedGame, GoesOnFromAnyMomentAndEveryTimeTheSame) {
  for (const std::int64_t tick : {std::int64_t{1}, std::int64_t{433}, original.ticks - 500}) {
    const record::MatchRecord first = play(continued(tick));
    const record::MatchRecord second = play(continued(tick));
    ASSERT_EQ(first.termination, Termination::Finished) << first.reason;
    EXPECT_EQ(first.hash, second.hash);
    // What was called before is as it was.
    const world::Time moment = world::tick_time(tick);
    for (std::size_t i = 0; i < original.timeline.size() && original.timeline[i].time <= moment; ++i) {
      ASSERT_LT(i, first.timeline.size());
      EXPECT_EQ(first.timeline[i], original.timeline[i]);
    }
  }
}

TEST_F(RecordedGame, ATeamWithoutMemoryDoesNotNoticeThatItStartsAnew) {
  MatchConfig still = fakes::short_game("good", "good");
  still.half_length = 2;
  still.recording = directory / "still.replies.gz";
  const record::MatchRecord whole = play(still);
  ASSERT_EQ(whole.termination, Termination::Finished) << whole.reason;
  MatchConfig again = still;
  again.recording = directory / "still-again.replies";
  again.continuation = Continuation{*still.recording, 77};
  EXPECT_EQ(play(again).hash, whole.hash);
  // And the recording of the continuation is a recording as any other.
  again.continuation = Continuation{*again.recording, std::nullopt};
  again.recording.reset();
  EXPECT_EQ(play(again).hash, whole.hash);
}

TEST_F(RecordedGame, OfAnotherWorldIsNoticedAtTheNextSecond) {
  MatchConfig other = continued(600);
  other.realism.changes["robots.max_speed"] = 1;  // as another build would
  const record::MatchRecord record = play(other);
  EXPECT_EQ(record.termination, Termination::HarnessFault);
  EXPECT_THAT(record.reason, HasSubstr("goes differently at tick"));
}

TEST_F(RecordedGame, ThatIsDamagedIsNamed) {
  const auto complaint = [](const std::filesystem::path& path) -> std::string {
    try {
      recorded_config(path);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(complaint(directory / "none.replies"), HasSubstr("none.replies: cannot be"));
  const std::filesystem::path file = directory / "bad.replies";
  for (const std::string& content :
       {std::string(), std::string("SSL_LOG_FILE\0\0\0\1", 16), std::string(100, 'x')}) {
    std::ofstream(file, std::ios::binary) << content;
    EXPECT_THAT(complaint(file), HasSubstr("bad.replies: "));
  }
}

TEST_F(RecordedGame, WhoseConfigurationCannotBePlayedIsRefused) {
  wire::RecordingReader reader(*config.recording);
  const std::filesystem::path file = directory / "empty.replies";
  const auto complaint = [&](const MatchConfig& wrong) -> std::string {
    wire::RecordingWriter writer(file);
    wire::proto::Recorded record;
    *record.mutable_start() = reader.start();
    record.mutable_start()->set_config(record::to_json(wrong));
    writer.write(record);
    writer.close();
    try {
      recorded_config(file);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(complaint(config), "accepted");
  MatchConfig wrong = config;
  wrong.teams.blue.command = {};
  EXPECT_THAT(complaint(wrong), HasSubstr("empty.replies: blue ("));
  EXPECT_THAT(complaint(wrong), HasSubstr("command is empty"));
  wrong = config;
  wrong.teams.yellow.robots = {99};
  EXPECT_THAT(complaint(wrong), HasSubstr("empty.replies: yellow ("));
}

TEST_F(RecordedGame, ThatIsCutOffIsPlayedAsFarAsItGoes) {
  std::ifstream in(*config.recording, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  const std::filesystem::path file = directory / "cut.replies";
  std::ofstream(file, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  MatchConfig half = continued(std::nullopt);
  half.continuation->recording = file;
  const record::MatchRecord record = play(half);
  EXPECT_EQ(record.termination, Termination::Interrupted);
  EXPECT_EQ(record.reason, "the recording is cut off here");
  EXPECT_GT(record.ticks, original.ticks / 4);
}

// A live team is asked; what a file says must be checked the same way.
TEST_F(RecordedGame, WhoseKeeperIsNotOnTheFieldIsDamaged) {
  wire::RecordingReader reader(*config.recording);
  const std::filesystem::path file = directory / "keeper.replies";
  const auto write = [&](bool in_hello) {
    wire::RecordingWriter writer(file);
    wire::proto::Recorded record;
    *record.mutable_start() = reader.start();
    if (in_hello) record.mutable_start()->mutable_blue()->set_keeper(4'000'000'000U);
    writer.write(record);
    record.mutable_tick()->set_tick(1);
    if (!in_hello) record.mutable_tick()->mutable_new_yellow()->set_keeper(7);
    writer.write(record);
    writer.close();
  };
  MatchConfig again = continued(std::nullopt);
  again.continuation->recording = file;
  write(true);
  EXPECT_THAT(play(again).reason, HasSubstr("keeper.replies: tick 0: blue wants robot 4000000000"));
  write(false);
  EXPECT_THAT(play(again).reason, HasSubstr("keeper.replies: tick 1: yellow wants robot 7"));
}

}  // namespace
}  // namespace host
