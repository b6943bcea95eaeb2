// Five seconds of a real game of RoboCup 2022, as recorded by the league: two cameras at 73 Hz.
//
// The file has no licence and is not in the repository; without it these tests are skipped.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "sim/wire/log_messages.h"
#include "sim/wire/referee.h"
#include "sim/wire/vision.h"

namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;
using wire::Epoch;

class RealLog : public testing::Test {
 protected:
  void SetUp() override {
    const char* given = std::getenv("MATCHDAY_REAL_LOG");
    const std::filesystem::path path =
        given ? given : SOURCE_DIR "/../shared/data/robocup2022_kiks_vs_erforce_5s.log";
    if (!given && !std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    wire::LogReader reader(path);
    wire::LogRecord record;
    while (reader.next(record)) records_.push_back(record);
    truncated_ = reader.truncated();
  }

  std::vector<wire::LogRecord> records_;
  bool truncated_ = false;
};

}  // namespace

TEST_F(RealLog, HasAllItsRecords) {
  std::map<std::int32_t, int> types;
  for (const wire::LogRecord& record : records_) ++types[record.type];
  EXPECT_EQ(records_.size(), 2264U);
  EXPECT_THAT(types, ElementsAre(Pair(wire::Vision2010, 734), Pair(wire::Refbox2013, 396),
                                 Pair(wire::Vision2014, 734), Pair(wire::Tracker2020, 400)));
  EXPECT_FALSE(truncated_);
}

TEST_F(RealLog, EveryMessageDecodes) {
  int frames = 0;
  int geometries = 0;
  matchday::vision::SSL_WrapperPacket packet;
  matchday::referee::Referee referee;
  matchday::tracker::TrackerWrapperPacket tracked;
  for (const wire::LogRecord& record : records_) {
    if (record.type == wire::Vision2014) {
      ASSERT_TRUE(wire::read(record, packet));
      EXPECT_TRUE(packet.unknown_fields().empty());
      if (packet.has_detection()) {
        EXPECT_TRUE(wire::usable(packet.detection()));
        ++frames;
      }
      if (packet.has_geometry()) {
        EXPECT_TRUE(wire::decode(packet.geometry()).has_value());
        ++geometries;
      }
    } else if (record.type == wire::Refbox2013) {
      ASSERT_TRUE(wire::read(record, referee));
      EXPECT_TRUE(wire::decode(referee, Epoch{}).has_value());
    } else if (record.type == wire::Tracker2020) {
      ASSERT_TRUE(wire::read(record, tracked));
      EXPECT_EQ(tracked.source_name(), "TIGERs");
    }
  }
  EXPECT_EQ(frames, 732);
  EXPECT_EQ(geometries, 2);
}

TEST_F(RealLog, TimesGrowByAFrameOfTheCamera) {
  std::map<int, world::Time> last;
  for (const wire::LogRecord& record : records_) {
    matchday::vision::SSL_WrapperPacket packet;
    if (!wire::read(record, packet) || !packet.has_detection()) continue;
    const world::Detection detection = wire::decode(packet.detection(), Epoch{});
    if (last.contains(detection.camera)) {
      const double step = world::seconds(detection.t_capture - last[detection.camera]);
      EXPECT_NEAR(step, 1 / 73.0, 0.01);  // up to one frame late: the recording is of a real computer
    }
    last[detection.camera] = detection.t_capture;
  }
  EXPECT_EQ(last.size(), 2U);
}

TEST_F(RealLog, WhatWeReadIsWhatWeWouldWrite) {
  for (const wire::LogRecord& record : records_) {
    matchday::vision::SSL_WrapperPacket packet;
    if (!wire::read(record, packet) || !packet.has_detection()) continue;
    wire::proto::SSL_DetectionFrame expected = packet.detection();
    // The nouns have no place for these.
    for (auto& robot : *expected.mutable_robots_yellow()) robot.clear_height();
    for (auto& robot : *expected.mutable_robots_blue()) robot.clear_height();
    wire::proto::SSL_DetectionFrame again;
    wire::encode(wire::decode(expected, Epoch{}), Epoch{}, again);
    ASSERT_EQ(again.SerializeAsString(), expected.SerializeAsString());
  }
}

TEST_F(RealLog, GeometryIsTheFieldOfDivisionA) {
  std::map<int, world::Vector3d> cameras;
  for (const wire::LogRecord& record : records_) {
    matchday::vision::SSL_WrapperPacket packet;
    if (!wire::read(record, packet) || !packet.has_geometry()) continue;
    const std::optional<world::Geometry> geometry = wire::decode(packet.geometry());
    ASSERT_TRUE(geometry.has_value());
    EXPECT_EQ(geometry->field.length, 12.04);
    EXPECT_EQ(geometry->field.width, 9.02);
    EXPECT_EQ(geometry->field.goal_width, 1.2);
    EXPECT_EQ(geometry->field.defense_area.shape, world::DefenseArea::Shape::Rectangle);
    EXPECT_EQ(geometry->field.defense_area.depth, 1.22);
    EXPECT_EQ(geometry->field.defense_area.width, 2.41);

    // Where the cameras are follows from rotation and translation too: an independent second answer.
    for (auto& calibration : *packet.mutable_geometry()->mutable_calib()) {
      calibration.clear_derived_camera_world_tx();
    }
    const std::optional<world::Geometry> computed = wire::decode(packet.geometry());
    ASSERT_EQ(computed->cameras.size(), geometry->cameras.size());
    for (std::size_t i = 0; i < computed->cameras.size(); ++i) {
      // The message rounds the quaternion to six decimals: 6 m high, that is some hundredths of a millimetre.
      EXPECT_LT((computed->cameras[i].position - geometry->cameras[i].position).norm(), 1e-3);
      cameras[geometry->cameras[i].id] = geometry->cameras[i].position;
    }
  }
  EXPECT_FALSE(cameras.empty());
}

TEST_F(RealLog, RefereeSaysDirectFreeKickForBlue) {
  for (const wire::LogRecord& record : records_) {
    matchday::referee::Referee referee;
    if (!wire::read(record, referee)) continue;
    const std::optional<world::RefereeMessage> message = wire::decode(referee, Epoch{});
    ASSERT_TRUE(message.has_value());
    EXPECT_EQ(message->stage, world::Stage::First);
    EXPECT_EQ(message->command, (world::Command{world::CommandKind::Direct, world::Team::Blue}));
    EXPECT_EQ(message->teams.yellow.name, "KIKS");
    EXPECT_EQ(message->teams.blue.name, "ER-Force");
    EXPECT_FALSE(message->blue_on_positive_half);
  }
}
