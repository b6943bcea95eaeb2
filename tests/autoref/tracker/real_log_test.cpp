#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "autoref/tracker/frame_grouper.h"
#include "autoref/tracker/tracker.h"
#include "sim/wire/log_file.h"
#include "sim/wire/vision.h"

namespace tracker {
namespace {

std::filesystem::path real_log() {
  if (const char* path = std::getenv("MATCHDAY_REAL_LOG")) return path;
  return std::filesystem::path(SOURCE_DIR) / "../shared/data/robocup2022_kiks_vs_erforce_5s.log";
}

// Five seconds of a real game (RoboCup 2022, two cameras at 73 Hz, 12 m x 9 m):
// finite, in order, one ball, two teams.
TEST(Tracker, FollowsARealGame) {
  if (!std::filesystem::exists(real_log())) GTEST_SKIP() << "no " << real_log();
  world::Geometry geometry;
  geometry.field.length = 12;
  geometry.field.width = 9;
  Tracker tracker{geometry};
  FrameGrouper grouper;

  int images = 0, frames = 0, with_ball = 0, ball_seen = 0, wild = 0, robots = 0, fast_robots = 0;
  std::set<world::RobotId> ids;
  world::Time last{world::Duration::min()};
  const auto feed = [&](std::span<const world::Detection> batch) {
    if (batch.empty()) return;
    const world::TrackedFrame* frame = tracker.update(batch);
    if (!frame) return;
    ++frames;
    ASSERT_GT(frame->time, last);
    last = frame->time;
    if (frame->ball) {
      ASSERT_TRUE(frame->ball->position.allFinite());
      ASSERT_TRUE(frame->ball->velocity.allFinite());
      ++with_ball;
      ball_seen += frame->ball->observed;
      wild += frame->ball->velocity.norm() > 10;
    }
    for (const world::TrackedRobot& robot : frame->robots) {
      ASSERT_TRUE(robot.position.allFinite());
      ASSERT_TRUE(robot.velocity.allFinite());
      ASSERT_TRUE(std::isfinite(robot.orientation));
      fast_robots += robot.velocity.norm() > 6;
      ++robots;
      ids.insert(robot.id);
    }
  };

  wire::LogReader reader(real_log());
  wire::LogRecord record;
  while (reader.next(record)) {
    if (record.type != wire::Vision2014) continue;
    wire::proto::SSL_WrapperPacket packet;
    ASSERT_TRUE(packet.ParseFromString(record.payload));
    if (!packet.has_detection()) continue;
    ++images;
    feed(grouper.add(wire::decode(packet.detection(), wire::Epoch{})));
  }
  feed(grouper.flush());

  int yellow = 0;
  for (const world::RobotId id : ids) yellow += id.team == world::Team::Yellow;
  std::cout << "real log: " << images << " images, " << frames << " frames, ball in " << with_ball
            << ", seen in " << ball_seen << ", faster than 10 m/s in " << wild << "; yellow robots " << yellow
            << ", blue robots " << ids.size() - static_cast<std::size_t>(yellow) << ", restarts "
            << tracker.restarts() << "\n";
  EXPECT_GT(frames, 300);  // 5 s at 73 Hz are 365
  EXPECT_GT(with_ball, frames / 2);
  EXPECT_EQ(wild, 0);
  EXPECT_EQ(fast_robots, 0);  // no robot of the league reaches 6 m/s
  EXPECT_GE(yellow, 5);
  EXPECT_GE(static_cast<int>(ids.size()) - yellow, 5);
  EXPECT_EQ(tracker.restarts(), 0);
}

}  // namespace
}  // namespace tracker
