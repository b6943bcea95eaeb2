#include <gmock/gmock.h>

#include <limits>

#include "sim/wire/vision.h"
#include "sim/world/random.h"
#include "tests/sim/wire/allocations.h"
#include "tests/sim/wire/league_schema.h"

namespace {

using testing::IsEmpty;
using wire::Epoch;
using world::as_float;
using world::Team;
using world::Vector2d;

const float nan_value = std::numeric_limits<float>::quiet_NaN();
const float infinity = std::numeric_limits<float>::infinity();

/// A detection with values as vision makes them: rounded to the wire's types.
world::Detection quantised(world::RandomStream& random) {
  const auto position = [&] {
    return world::as_on_wire(Vector2d(12 * (random.uniform() - 0.5), 9 * (random.uniform() - 0.5)));
  };
  const auto pixel = [&] {
    return Vector2d(as_float(1280 * random.uniform()), as_float(1024 * random.uniform()));
  };
  world::Detection result;
  result.camera = static_cast<int>(random.below(4));
  result.frame_number = static_cast<std::uint32_t>(random.below(1'000'000));
  const auto tick = static_cast<std::int64_t>(random.below(144'000));
  result.t_capture = world::whole_microseconds(world::tick_time(tick, 1 + result.camera));
  result.t_sent = world::whole_microseconds(world::tick_time(tick + 1));
  for (std::uint64_t i = random.below(3); i > 0; --i) {
    result.balls.push_back(
        {position(), as_float(random.uniform()), static_cast<std::uint32_t>(random.below(100)), pixel()});
  }
  for (const Team team : world::both_teams) {
    for (std::uint8_t number = 0; number < 6; ++number) {
      world::DetectedRobot robot{
          team,   number, position(), as_float(6 * (random.uniform() - 0.5)), as_float(random.uniform()),
          pixel()};
      if (random.below(10) == 0) robot.number.reset();
      if (random.below(10) == 0) robot.orientation.reset();
      result.robots.push_back(robot);
    }
  }
  return result;
}

void expect_same_bits(const world::Detection& a, const world::Detection& b) {
  EXPECT_EQ(a.camera, b.camera);
  EXPECT_EQ(a.frame_number, b.frame_number);
  EXPECT_EQ(a.t_capture, b.t_capture);
  EXPECT_EQ(a.t_sent, b.t_sent);
  ASSERT_EQ(a.balls.size(), b.balls.size());
  for (std::size_t i = 0; i < a.balls.size(); ++i) {
    EXPECT_EQ(a.balls[i].position, b.balls[i].position);
    EXPECT_EQ(a.balls[i].confidence, b.balls[i].confidence);
    EXPECT_EQ(a.balls[i].area, b.balls[i].area);
    EXPECT_EQ(a.balls[i].pixel, b.balls[i].pixel);
  }
  ASSERT_EQ(a.robots.size(), b.robots.size());
  for (std::size_t i = 0; i < a.robots.size(); ++i) {
    EXPECT_EQ(a.robots[i].team, b.robots[i].team);
    EXPECT_EQ(a.robots[i].number, b.robots[i].number);
    EXPECT_EQ(a.robots[i].position, b.robots[i].position);
    EXPECT_EQ(a.robots[i].orientation, b.robots[i].orientation);
    EXPECT_EQ(a.robots[i].confidence, b.robots[i].confidence);
    EXPECT_EQ(a.robots[i].pixel, b.robots[i].pixel);
  }
}

/// A frame with one good ball and one good robot of each team.
wire::proto::SSL_DetectionFrame good_frame() {
  world::Detection detection;
  detection.balls.push_back({});
  detection.robots.push_back({.team = Team::Yellow, .number = 3, .orientation = 1.0});
  detection.robots.push_back({.team = Team::Blue, .number = 4, .orientation = 1.0});
  wire::proto::SSL_DetectionFrame frame;
  wire::encode(detection, Epoch{}, frame);
  return frame;
}

}  // namespace

TEST(Detection, ComesBackFromTheWireWithTheSameBits) {
  world::RandomStream random(1, "detections");
  for (int i = 0; i < 1000; ++i) {
    const world::Detection sent = quantised(random);
    wire::proto::SSL_DetectionFrame frame;
    wire::encode(sent, Epoch{}, frame);
    wire::proto::SSL_DetectionFrame received;
    ASSERT_TRUE(received.ParseFromString(frame.SerializeAsString()));
    expect_same_bits(wire::decode(received, Epoch{}), sent);
  }
}

TEST(Detection, DecodingAndEncodingAgainGivesTheSameBytes) {
  world::RandomStream random(2, "detections");
  for (int i = 0; i < 1000; ++i) {
    wire::proto::SSL_DetectionFrame frame;
    wire::encode(quantised(random), Epoch{}, frame);
    wire::proto::SSL_DetectionFrame again;
    wire::encode(wire::decode(frame, Epoch{}), Epoch{}, again);
    ASSERT_EQ(again.SerializeAsString(), frame.SerializeAsString());
  }
}

TEST(Detection, PositionsComeBackAsTheNounsRoundThem) {
  world::RandomStream random(3, "positions");
  wire::proto::SSL_DetectionFrame frame;
  for (int i = 0; i < 100'000; ++i) {
    const Vector2d position(20 * (random.uniform() - 0.5), 1e-3 * (random.uniform() - 0.5));
    world::Detection detection;
    detection.balls.push_back({.position = position});
    wire::encode(detection, Epoch{}, frame);
    const Vector2d back = wire::decode(frame, Epoch{}).balls.at(0).position;
    ASSERT_EQ(back, world::as_on_wire(position));
    ASSERT_EQ(back, world::as_on_wire(back));
  }
}

TEST(Detection, TravelsInMillimetresAndUnixSeconds) {
  world::Detection detection;
  detection.camera = 2;
  detection.frame_number = 7;
  detection.t_capture = world::tick_time(60);
  detection.t_sent = world::tick_time(90);
  detection.balls.push_back({.position = {1.5, -0.25}});
  detection.robots.push_back({.team = Team::Blue, .number = 5, .position = {-4.5, 3}, .orientation = 0.5});
  wire::proto::SSL_DetectionFrame frame;
  wire::encode(detection, Epoch{}, frame);
  EXPECT_EQ(frame.camera_id(), 2U);
  EXPECT_EQ(frame.frame_number(), 7U);
  EXPECT_EQ(frame.t_capture(), 1'700'000'001.0);
  EXPECT_EQ(frame.t_sent(), 1'700'000'001.5);
  EXPECT_EQ(frame.balls(0).x(), 1500.0F);
  EXPECT_EQ(frame.balls(0).y(), -250.0F);
  EXPECT_EQ(frame.robots_yellow_size(), 0);
  EXPECT_EQ(frame.robots_blue(0).robot_id(), 5U);
  EXPECT_EQ(frame.robots_blue(0).x(), -4500.0F);
  EXPECT_EQ(frame.robots_blue(0).orientation(), 0.5F);
}

TEST(Detection, SetsEveryFieldTheLeagueRequires) {
  const wire::proto::SSL_DetectionFrame frame = good_frame();
  EXPECT_THAT(league::missing_required(frame, "ssl-vision HEAD"), IsEmpty());
  wire::proto::SSL_DetectionFrame gap = frame;
  gap.mutable_balls(0)->clear_x();
  EXPECT_EQ(league::missing_required(gap, "ssl-vision HEAD").size(), 1U) << "this check can fail";
}

TEST(Detection, ReusesMemoryBothWays) {
  world::RandomStream random(4, "detections");
  std::vector<world::Detection> inputs;
  for (int i = 0; i < 50; ++i) inputs.push_back(quantised(random));
  wire::proto::SSL_DetectionFrame frame;
  world::Detection out;
  for (const world::Detection& input : inputs) {  // grow
    wire::encode(input, Epoch{}, frame);
    wire::decode(frame, Epoch{}, out);
  }
  const std::size_t before = allocations();
  for (const world::Detection& input : inputs) {
    wire::encode(input, Epoch{}, frame);
    wire::decode(frame, Epoch{}, out);
  }
  EXPECT_EQ(allocations(), before);
  EXPECT_GT(before, 0U) << "the counter counts";
}

TEST(Detection, DropsObjectsWithoutAPosition) {
  for (const float bad : {nan_value, infinity, -infinity, 1e6F}) {
    wire::proto::SSL_DetectionFrame frame = good_frame();
    frame.mutable_balls(0)->set_x(bad);
    frame.mutable_robots_yellow(0)->set_y(bad);
    const world::Detection detection = wire::decode(frame, Epoch{});
    EXPECT_THAT(detection.balls, IsEmpty()) << bad;
    ASSERT_EQ(detection.robots.size(), 1U) << bad;
    EXPECT_EQ(detection.robots[0].team, Team::Blue);
  }
  wire::proto::SSL_DetectionFrame frame = good_frame();
  frame.mutable_balls(0)->clear_x();
  frame.mutable_robots_blue(0)->clear_y();
  EXPECT_THAT(wire::decode(frame, Epoch{}).balls, IsEmpty());
  EXPECT_EQ(wire::decode(frame, Epoch{}).robots.size(), 1U);
}

TEST(Detection, KeepsRobotsWithoutANumberOrOrientation) {
  wire::proto::SSL_DetectionFrame frame = good_frame();
  frame.mutable_robots_yellow(0)->clear_robot_id();
  frame.mutable_robots_yellow(0)->clear_orientation();
  frame.mutable_robots_blue(0)->set_robot_id(16);
  frame.mutable_robots_blue(0)->set_orientation(nan_value);
  frame.mutable_robots_blue(0)->set_confidence(nan_value);
  frame.mutable_robots_blue(0)->set_pixel_x(infinity);
  const world::Detection detection = wire::decode(frame, Epoch{});
  ASSERT_EQ(detection.robots.size(), 2U);
  for (const world::DetectedRobot& robot : detection.robots) {
    EXPECT_FALSE(robot.number.has_value());
    EXPECT_FALSE(robot.orientation.has_value());
  }
  EXPECT_EQ(detection.robots[1].confidence, 0);
  EXPECT_EQ(detection.robots[1].pixel.x(), 0);
}

TEST(Detection, AFrameWithoutTimeOrCameraIsNotUsableAndEmpty) {
  EXPECT_TRUE(wire::usable(good_frame()));
  for (const double bad : {std::nan(""), 1e300, -5.0}) {
    wire::proto::SSL_DetectionFrame frame = good_frame();
    frame.set_t_capture(bad);
    EXPECT_FALSE(wire::usable(frame));
    EXPECT_THAT(wire::decode(frame, Epoch{}).robots, IsEmpty());
  }
  wire::proto::SSL_DetectionFrame no_camera = good_frame();
  no_camera.clear_camera_id();
  EXPECT_FALSE(wire::usable(no_camera));
  wire::proto::SSL_DetectionFrame strange_camera = good_frame();
  strange_camera.set_camera_id(4'000'000'000U);
  EXPECT_FALSE(wire::usable(strange_camera));
  wire::proto::SSL_DetectionFrame no_sending_time = good_frame();
  no_sending_time.set_t_sent(std::nan(""));
  EXPECT_TRUE(wire::usable(no_sending_time));
  EXPECT_EQ(wire::decode(no_sending_time, Epoch{}).t_sent, world::Time{});
}

TEST(Detection, LeavesOutWhatIsMoreThanAnImageCanHold) {
  wire::proto::SSL_DetectionFrame frame = good_frame();
  const auto ball = frame.balls(0);
  const auto yellow = frame.robots_yellow(0);
  for (int i = 0; i < 5000; ++i) *frame.add_balls() = ball;
  for (int i = 0; i < 5000; ++i) *frame.add_robots_yellow() = yellow;
  const world::Detection decoded = wire::decode(frame, Epoch{});
  EXPECT_EQ(decoded.balls.size(), 256U);
  EXPECT_EQ(decoded.robots.size(), 64U);
}
