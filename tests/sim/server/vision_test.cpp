// The camera frames: one packet each, at their own phase, in the league's schema, without a seam when the
// engine is exchanged.
#include <gmock/gmock.h>

#include <map>

#include "sim/wire/epoch.h"
#include "tests/sim/server/bench.h"

namespace {

using bench::Bench;
using testing::IsEmpty;
namespace proto = bench::proto;

const std::string vision = "ssl-vision HEAD";

matchday::vision::SSL_WrapperPacket parsed(const std::string& bytes) {
  matchday::vision::SSL_WrapperPacket packet;
  EXPECT_TRUE(packet.ParseFromString(bytes));
  EXPECT_THAT(league::missing_required(packet, vision), IsEmpty());
  EXPECT_EQ(packet.source(), matchday::vision::SSL_SOURCE_OTHER);
  return packet;
}

}  // namespace

TEST(VisionPackets, EachCameraHasItsPhase) {
  Bench b;  // no delay
  for (int tick = 0; tick < 3; ++tick) {
    const auto packets = b.server.step();
    ASSERT_EQ(packets.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto packet = parsed(packets[i].bytes);
      EXPECT_FALSE(packet.has_geometry());
      const auto& frame = packet.detection();
      EXPECT_EQ(frame.camera_id(), i);
      EXPECT_EQ(frame.frame_number(), static_cast<unsigned>(tick));
      const world::Time taken = world::whole_microseconds(world::tick_time(tick, static_cast<int>(i) + 1));
      EXPECT_EQ(frame.t_capture(), wire::to_unix_seconds(taken, {}));
      EXPECT_EQ(frame.t_sent(), frame.t_capture());
      EXPECT_EQ(packets[i].due, taken);
    }
  }
}

TEST(VisionPackets, LeaveLaterByTheDelay) {
  Bench b("measured");  // one tick
  EXPECT_TRUE(b.server.step().empty());
  const auto packets = b.server.step();
  ASSERT_EQ(packets.size(), 4U);
  const auto frame = parsed(packets[0].bytes).detection();
  EXPECT_EQ(frame.t_capture(), wire::to_unix_seconds(world::whole_microseconds(world::tick_time(0, 1)), {}));
  // Whole microseconds each: 1/60 s is rounded once more.
  EXPECT_NEAR(frame.t_sent() - frame.t_capture(), 1.0 / 60, 1.1e-6);
  EXPECT_GT(packets[0].due, world::tick_time(1));
  EXPECT_LE(packets[3].due, world::tick_time(2) + std::chrono::microseconds{1});
}

TEST(VisionPackets, GoOnWhenTheEngineIsExchanged) {
  Bench b("measured");
  std::map<unsigned, std::pair<unsigned, double>> last;  // frame number and capture time by camera
  int frames = 0;
  for (int i = 0; i < 30; ++i) {
    if (i % 7 == 3) {
      proto::SimulatorCommand command;
      auto& specs = *command.mutable_config()->add_robot_specs();
      specs.mutable_id()->set_id(1);
      specs.mutable_id()->set_team(proto::BLUE);
      specs.set_mass(2.0F + 0.01F * static_cast<float>(i));
      EXPECT_EQ(b.codes(command), "");
    }
    for (const server::VisionPacket& packet : b.server.step()) {
      const auto frame = parsed(packet.bytes).detection();
      const auto found = last.find(frame.camera_id());
      if (found != last.end()) {
        EXPECT_EQ(frame.frame_number(), found->second.first + 1);
        EXPECT_GT(frame.t_capture(), found->second.second + 0.016);
      }
      last[frame.camera_id()] = {frame.frame_number(), frame.t_capture()};
      ++frames;
    }
  }
  // 30 ticks less one for the delay at first and one for each of the four exchanges.
  EXPECT_EQ(frames, (30 - 1 - 4) * 4);
}

TEST(VisionPackets, AreNotDisturbedByWhatChangesNothing) {
  Bench b("measured");
  Bench undisturbed("measured");
  for (int i = 0; i < 30; ++i) {
    proto::SimulatorCommand command;
    matchday::vision::SSL_WrapperPacket packet;
    ASSERT_TRUE(packet.ParseFromString(b.server.geometry()));
    auto& config = *command.mutable_config();
    *config.mutable_geometry() = packet.geometry();
    auto& same = *config.add_robot_specs();
    same.mutable_id()->set_id(1);
    same.mutable_id()->set_team(proto::BLUE);
    same.set_mass(2.5);
    *config.add_robot_specs() = same;
    config.mutable_robot_specs(1)->set_mass(-1);
    config.mutable_realism_config()->add_custom()->set_type_url("somebody.Else");
    EXPECT_EQ(b.codes(command), "INVALID_SPEC UNSUPPORTED ");
    const auto packets = b.server.step();
    const auto expected = undisturbed.server.step();
    ASSERT_EQ(packets.size(), expected.size());
    for (std::size_t k = 0; k < packets.size(); ++k) EXPECT_EQ(packets[k].bytes, expected[k].bytes);
  }
}

TEST(VisionPackets, TheGeometryIsWhole) {
  Bench b;
  const auto packet = parsed(b.server.geometry());
  EXPECT_FALSE(packet.has_detection());
  EXPECT_EQ(packet.geometry().calib_size(), 4);
  EXPECT_LE(b.server.geometry().size(), 8192U);
}
