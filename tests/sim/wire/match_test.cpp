#include "sim/wire/match.h"

#include <gtest/gtest.h>

#include "sim/wire/delimited.h"

namespace {

wire::proto::MatchTick some_tick() {
  wire::proto::MatchTick tick;
  tick.set_tick(77);
  tick.set_time_us(1'700'000'001'283'333);
  for (int camera = 0; camera < 4; ++camera) {
    world::Detection detection;
    detection.camera = camera;
    wire::encode(detection, wire::Epoch{}, *tick.add_packets()->mutable_detection());
  }
  wire::encode(world::RefereeMessage{}, wire::Epoch{}, *tick.mutable_referee());
  return tick;
}

}  // namespace

TEST(TickFrame, IsTheFrameOfTheWholeMessage) {
  for (const std::size_t robots : {0U, 6U, 16U}) {
    std::vector<wire::Feedback> feedback;
    for (std::size_t i = 0; i < robots; ++i) feedback.push_back({static_cast<std::uint8_t>(i), i % 2 == 0});

    wire::proto::HostMessage whole;
    *whole.mutable_tick() = some_tick();
    wire::encode(feedback, *whole.mutable_tick()->mutable_feedback());
    std::string expected;
    wire::append_frame(expected, whole);

    std::string pieced;
    wire::append_tick_frame(pieced, some_tick().SerializeAsString(), whole.tick().feedback());
    EXPECT_EQ(pieced, expected);
  }
}

TEST(TickFrame, RefusesWhatNoReaderWouldTake) {
  std::string out;
  EXPECT_THROW(wire::append_tick_frame(out, std::string(wire::max_frame_size, 'x'), {}), wire::FrameError);
  EXPECT_TRUE(out.empty());
}
