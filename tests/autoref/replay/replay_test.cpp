#include "autoref/replay.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "autoref/referee/referee.h"
#include "sim/wire/log_file.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"

namespace autoref {
namespace {

using ::testing::HasSubstr;
using world::Team;
using world::Vector2d;

// A short game of two robots as our host would log it, and the calls that the referee in it made.
class Replay : public ::testing::Test {
 protected:
  Replay()
      : file_(std::filesystem::path(::testing::TempDir()) / ("replay_" + std::to_string(getpid()) + ".log")) {
    referee::Setup setup;
    setup.rules.half_length = world::from_seconds(5);
    setup.first_kickoff = Team::Blue;
    setup.blue_on_positive_half = false;
    setup.keeper = {4, 5};
    setup.names = {"Ay", "Bee"};
    referee::Referee referee(setup);
    wire::LogWriter log(file_);
    write_geometry(log, setup);
    write_referee(log, {}, referee, referee::setup_text(setup));
    for (std::int64_t tick = 1; tick < 60 * 30; ++tick) {
      const auto batch = images(tick);
      if (tick == 700) referee.request_timeout(Team::Yellow);
      if (tick == 1200) referee.end_timeout(Team::Yellow);
      for (const referee::Call& call : referee.update(batch).calls)
        calls_ += referee::format_call(call) + "\n";
      for (const world::Detection& image : batch) write_vision(log, tick, image);
      write_referee(log, world::tick_time(tick), referee, "");
    }
    log.close();
  }
  ~Replay() override { std::filesystem::remove(file_); }

  // The ball waits at its place, then rolls over the touch line, again and again.
  std::vector<world::Detection> images(std::int64_t tick) {
    const std::int64_t phase = tick % 300;
    const double y = phase < 200 ? 0.0 : 3.4 * static_cast<double>(phase - 200) / 100.0;
    std::vector<world::Detection> batch;
    for (int camera = 0; camera < 2; ++camera) {
      world::Detection image;
      image.camera = camera;
      image.t_capture = world::whole_microseconds(world::tick_time(tick, camera + 1));
      image.t_sent = image.t_capture;
      image.balls.push_back({.position = world::as_on_wire(Vector2d{0, y})});
      image.robots.push_back({.team = Team::Yellow, .number = 4, .position = {1, 1}, .orientation = 0.0});
      image.robots.push_back({.team = Team::Blue, .number = 5, .position = {-0.12, 0}, .orientation = 0.0});
      batch.push_back(image);
    }
    return batch;
  }

  static std::int64_t receive_time(world::Time time) {
    return wire::Epoch{}.nanoseconds + time.time_since_epoch().count();
  }
  static void write_geometry(wire::LogWriter& log, const referee::Setup& setup) {
    wire::proto::SSL_WrapperPacket packet;
    wire::encode(setup.geometry, *packet.mutable_geometry());
    log.write(receive_time({}), wire::Vision2014, packet);
  }
  static void write_vision(wire::LogWriter& log, std::int64_t tick, const world::Detection& image) {
    wire::proto::SSL_WrapperPacket packet;
    wire::encode(image, wire::Epoch{}, *packet.mutable_detection());
    log.write(receive_time(world::tick_time(tick)), wire::Vision2014, packet);
  }
  static void write_referee(wire::LogWriter& log, world::Time time, const referee::Referee& referee,
                            const std::string& status) {
    wire::proto::Referee message;
    wire::encode(referee.message(), wire::Epoch{}, message);
    message.set_source_identifier("matchday");
    if (!status.empty()) message.set_status_message(status);
    log.write(receive_time(time), wire::Refbox2013, message);
  }

  int run(ReplayOptions options) {
    out_.str("");
    errors_.str("");
    return replay(options, out_, errors_);
  }

  std::filesystem::path file_;
  std::string calls_;
  std::ostringstream out_;
  std::ostringstream errors_;
};

TEST_F(Replay, OfAGameOfOursGivesTheSameCallsAtTheSameTimes) {
  ASSERT_EQ(run({.file = file_, .rules = "", .json = false}), 0) << errors_.str();
  EXPECT_THAT(calls_, HasSubstr("T11.7"));
  EXPECT_THAT(calls_, HasSubstr("T16.b"));
  EXPECT_THAT(calls_, HasSubstr("T17.c"));
  EXPECT_EQ(out_.str().substr(0, out_.str().find("records:")), calls_);
}

TEST_F(Replay, WatchesWhenAsked) {
  ReplayOptions options;
  options.file = file_;
  options.mode = ReplayOptions::Mode::Watch;
  EXPECT_EQ(run(options), 0);
  EXPECT_THAT(out_.str(), HasSubstr("touch line"));
  EXPECT_THAT(out_.str(), HasSubstr("camera 1 with 1799 images at 60.0 Hz"));
  EXPECT_THAT(out_.str(), HasSubstr("robots:  yellow 4, blue 5"));
}

TEST_F(Replay, PrintsOneObjectALineAsJson) {
  ReplayOptions options;
  options.file = file_;
  options.json = true;
  EXPECT_EQ(run(options), 0);
  std::istringstream lines(out_.str());
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line.front(), '{');
    EXPECT_EQ(line.back(), '}');
  }
}

TEST_F(Replay, OfACutLogPrintsWhatThereIsAndSaysWhereItEnds) {
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 5);
  ReplayOptions options;
  options.file = file_;
  EXPECT_EQ(run(options), 2);
  EXPECT_THAT(out_.str(), HasSubstr("T11.7"));
  EXPECT_THAT(errors_.str(), HasSubstr("record "));
  EXPECT_THAT(errors_.str(), HasSubstr(file_.string()));
  EXPECT_EQ(std::ranges::count(errors_.str(), '\n'), 1);
}

TEST_F(Replay, OfADamagedLogSaysWhere) {
  std::fstream file(file_, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(16 + 12);  // the length of the first record
  file.write("\x7f\xff\xff\xff", 4);
  file.close();
  ReplayOptions options;
  options.file = file_;
  EXPECT_EQ(run(options), 2);
  EXPECT_THAT(errors_.str(), HasSubstr("record 1"));
}

TEST_F(Replay, RefusesWhatIsNoLog) {
  ReplayOptions options;
  options.file = "/nowhere/game.log";
  EXPECT_THROW(run(options), std::exception);
  std::ofstream(file_) << "this is a diary";
  options.file = file_;
  EXPECT_THROW(run(options), std::exception);
}

}  // namespace
}  // namespace autoref
