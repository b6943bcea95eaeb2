#include "sim/wire/vision_packet.h"

#include <gmock/gmock.h>

#include "tests/sim/wire/league_schema.h"

namespace {

using testing::IsEmpty;

const std::string family = "ssl-vision HEAD";

wire::proto::SSL_WrapperPacket parsed(const std::string& bytes) {
  wire::proto::SSL_WrapperPacket packet;
  EXPECT_TRUE(packet.ParseFromString(bytes));
  EXPECT_EQ(packet.source(), wire::proto::SSL_SOURCE_OTHER);
  EXPECT_THAT(league::missing_required(packet, family), IsEmpty());
  return packet;
}

world::Detection detection_with(int balls, int robots) {
  world::Detection detection;
  detection.camera = 2;
  detection.frame_number = 4'000'000'000U;
  for (int i = 0; i < balls; ++i) detection.balls.push_back({.position = {0.001 * i, 1}});
  for (int i = 0; i < robots; ++i) {
    detection.robots.push_back({.team = i % 2 == 0 ? world::Team::Yellow : world::Team::Blue,
                                .number = static_cast<std::uint8_t>(i / 2),
                                .position = {1, 2},
                                .orientation = 3});
  }
  return detection;
}

}  // namespace

TEST(VisionPacket, HoldsOneCamerasFrame) {
  std::string bytes = "old";
  wire::encode_packet(detection_with(1, 32), {}, bytes);
  const auto packet = parsed(bytes);
  EXPECT_FALSE(packet.has_geometry());
  EXPECT_EQ(packet.detection().camera_id(), 2U);
  EXPECT_EQ(packet.detection().frame_number(), 4'000'000'000U);
  EXPECT_EQ(packet.detection().balls_size(), 1);
  EXPECT_EQ(packet.detection().robots_yellow_size(), 16);
  EXPECT_EQ(packet.detection().robots_blue_size(), 16);
}

TEST(VisionPacket, LeavesTheLastBallsOutWhenTheyDoNotFit) {
  std::string bytes;
  wire::encode_packet(detection_with(1000, 32), {}, bytes);
  EXPECT_LE(bytes.size(), 8192U);
  // A ball is at most 40 bytes here, so the next one would not have fitted.
  EXPECT_GT(bytes.size(), 8192U - 40);
  const auto packet = parsed(bytes);
  EXPECT_EQ(packet.detection().robots_blue_size(), 16) << "robots all stay";
  EXPECT_EQ(packet.detection().balls(0).x(), 0);
  EXPECT_EQ(packet.detection().balls(1).x(), 1) << "the first balls stay";
}

TEST(VisionPacket, HoldsFieldAndEveryCamera) {
  world::Geometry geometry;
  geometry.cameras = world::camera_grid(geometry.field, 8, 4.0);
  std::string bytes;
  wire::encode_packet(geometry, bytes);
  EXPECT_LE(bytes.size(), 8192U);
  const auto packet = parsed(bytes);
  EXPECT_FALSE(packet.has_detection());
  EXPECT_EQ(packet.geometry().calib_size(), 8);
  EXPECT_EQ(packet.geometry().field().field_length(), 9000);
}
