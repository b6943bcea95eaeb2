#include "teams/kit/session.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <thread>

#include "sim/wire/match.h"
#include "teams/kit/channel.h"

namespace kit {
namespace {

using matchday::match::HostMessage;
using matchday::match::TeamMessage;

// Drives every robot at 1 m/s along its own x.
class Forward final : public Team {
 public:
  void play(const View& view, world::TeamCommands& out) override {
    for (const Robot& robot : view.own) {
      world::RobotCommand command;
      command.number = robot.number;
      command.velocity_local = {1, 0};
      out.push_back(command);
    }
  }
  std::string_view note() const override { return "forward"; }
};

MakeTeam make_forward() {
  return [](const Setup&, bool) { return std::make_unique<Forward>(); };
}

HostMessage hello() {
  HostMessage message;
  auto& h = *message.mutable_hello();
  h.set_protocol_version(1);
  h.set_color(matchday::simulation::Team::BLUE);
  world::Geometry geometry;
  geometry.cameras = world::quarter_cameras(geometry.field);
  wire::encode(geometry, *h.mutable_geometry());
  for (const int number : {2, 4}) {
    world::RobotSpecs specs;
    specs.id = {world::Team::Blue, static_cast<std::uint8_t>(number)};
    wire::encode(specs, *h.add_robot_specs());
    h.add_robots(static_cast<std::uint32_t>(number));
  }
  h.set_command_latency(1);
  h.set_vision_latency(1);
  return message;
}

HostMessage tick(std::int64_t n, world::CommandKind kind = world::CommandKind::Start) {
  HostMessage message;
  auto& t = *message.mutable_tick();
  t.set_tick(n);
  world::Detection detection;
  detection.t_capture = world::whole_microseconds(world::tick_time(n - 1));
  detection.t_sent = detection.t_capture;
  detection.robots.push_back(
      {.team = world::Team::Blue, .number = std::uint8_t{4}, .position = {1, 1}, .orientation = 0.0});
  detection.balls.push_back({.position = {0, 0}});
  wire::encode(detection, wire::Epoch{}, *t.add_packets()->mutable_detection());
  world::RefereeMessage referee;
  referee.command = {kind, world::Team::Yellow};
  referee.command_counter = kind == world::CommandKind::Halt ? 1 : 2;
  wire::encode(referee, wire::Epoch{}, *t.mutable_referee());
  return message;
}

std::string payload(const HostMessage& message) { return message.SerializeAsString(); }
std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

TeamMessage unframed(std::string_view frame) {
  wire::FrameReader reader;
  reader.append(std::as_bytes(std::span(frame)));
  const auto body = reader.next();
  TeamMessage message;
  EXPECT_TRUE(body && message.ParseFromArray(body->data(), static_cast<int>(body->size())));
  EXPECT_EQ(reader.pending(), 0u);
  return message;
}

TEST(Session, AnswersTheHelloWithItsNameAndItsLowestRobotAsKeeper) {
  Session::Options options;
  options.name = "team-x";
  Session session(options, make_forward());
  const TeamMessage answer = unframed(session.answer(bytes(payload(hello()))));
  EXPECT_EQ(answer.hello().protocol_version(), 1u);
  EXPECT_EQ(answer.hello().name(), "team-x");
  EXPECT_EQ(answer.hello().keeper(), 2u);
}

TEST(Session, AnswersEveryTickWithItsNumber) {
  Session::Options options;
  options.notes = true;
  Session session(options, make_forward());
  session.answer(bytes(payload(hello())));
  for (std::int64_t n = 1; n <= 5; ++n) {
    const TeamMessage answer = unframed(session.answer(bytes(payload(tick(n)))));
    EXPECT_EQ(answer.reply().tick(), n);
    EXPECT_EQ(answer.reply().note(), "forward");
    if (n < 5) continue;
    ASSERT_EQ(answer.reply().control().robot_commands_size(), 1);
    EXPECT_EQ(answer.reply().control().robot_commands(0).id(), 4u);
    EXPECT_FLOAT_EQ(answer.reply().control().robot_commands(0).move_command().local_velocity().forward(), 1);
  }
}

TEST(Session, CommandsNothingDuringHalt) {
  Session session({}, make_forward());
  session.answer(bytes(payload(hello())));
  for (std::int64_t n = 1; n <= 5; ++n) {
    const TeamMessage answer = unframed(session.answer(bytes(payload(tick(n, world::CommandKind::Halt)))));
    EXPECT_EQ(answer.reply().control().robot_commands_size(), 0);
  }
}

TEST(Session, EndsAtTheGoodbye) {
  Session session({}, make_forward());
  HostMessage message;
  message.mutable_goodbye()->set_reason("the game is over");
  EXPECT_TRUE(session.answer(bytes(payload(message))).empty());
  EXPECT_TRUE(session.over());
  EXPECT_EQ(session.goodbye_reason(), "the game is over");
}

TEST(Session, RefusesWhatItCannotUnderstand) {
  Session session({}, make_forward());
  EXPECT_THROW(session.answer(bytes(std::string("\xff\xff\xff"))), std::runtime_error);
  EXPECT_THROW(session.answer(bytes(payload(tick(1)))), std::runtime_error) << "a tick before the hello";
  EXPECT_THROW(session.answer(bytes(payload(HostMessage{}))), std::runtime_error);
  HostMessage future = hello();
  future.mutable_hello()->set_protocol_version(2);
  EXPECT_THROW(session.answer(bytes(payload(future))), std::runtime_error);
  HostMessage blind = hello();
  blind.mutable_hello()->clear_geometry();
  EXPECT_THROW(session.answer(bytes(payload(blind))), std::runtime_error);
}

TEST(Channel, CarriesFramesCutAnywhere) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  Channel channel(ends[0]);
  std::string frames;
  wire::append_frame(frames, hello());
  wire::append_frame(frames, tick(1));
  std::thread host([&] {
    for (std::size_t at = 0; at < frames.size(); at += 7) {
      const std::size_t size = std::min<std::size_t>(7, frames.size() - at);
      EXPECT_EQ(::write(ends[1], frames.data() + at, size), static_cast<ssize_t>(size));
    }
    ::close(ends[1]);
  });
  const auto first = channel.read();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->size(), hello().ByteSizeLong());
  const auto second = channel.read();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->size(), tick(1).ByteSizeLong());
  EXPECT_FALSE(channel.read()) << "the host has closed";
  host.join();
}

TEST(Channel, SaysWhenTheStreamEndsInsideAMessage) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  Channel channel(ends[0]);
  ASSERT_EQ(::write(ends[1],
                    "\x05"
                    "ab",
                    3),
            3);
  ::close(ends[1]);
  EXPECT_THROW(channel.read(), std::runtime_error);
}

TEST(Channel, RefusesADamagedLength) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  Channel channel(ends[0]);
  ASSERT_EQ(::write(ends[1], "\xff\xff\xff\xff\xff\xff\xff", 7), 7);
  EXPECT_THROW(channel.read(), wire::FrameError);
  ::close(ends[1]);
}

}  // namespace
}  // namespace kit
