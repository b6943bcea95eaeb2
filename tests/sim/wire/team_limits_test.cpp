#include "sim/wire/team_limits.h"

#include <gtest/gtest.h>

namespace wire {
namespace {

/// As much as a reply can mean: every robot number, every field at its longest.
proto::MatchReply largest_reply() {
  proto::MatchReply reply;
  reply.set_tick(-1);  // ten bytes
  for (int robot = 0; robot < max_robot_commands; ++robot) {
    proto::RobotCommand& command = *reply.mutable_control()->add_robot_commands();
    command.set_id(0xFFFFFFFF);
    proto::MoveWheelVelocity& wheels = *command.mutable_move_command()->mutable_wheel_velocity();
    wheels.set_front_right(1);
    wheels.set_back_right(1);
    wheels.set_back_left(1);
    wheels.set_front_left(1);
    command.set_kick_speed(1);
    command.set_kick_angle(1);
    command.set_dribbler_speed(1);
  }
  reply.set_note(std::string(max_note, 'x'));
  reply.mutable_request()->set_keeper(0xFFFFFFFF);
  return reply;
}

TEST(TeamLimits, TheLargestReplyFitsIntoHalfAFrame) {
  EXPECT_EQ(excess(largest_reply()), "");
  EXPECT_LT(largest_reply().ByteSizeLong(), max_team_frame / 2);
}

TEST(TeamLimits, NamesWhatIsTooMuchWithNumberAndLimit) {
  proto::MatchReply reply = largest_reply();
  reply.mutable_control()->add_robot_commands();
  EXPECT_EQ(excess(reply), "sent 17 robot commands in one reply, 16 are allowed");
  reply = largest_reply();
  reply.mutable_note()->push_back('x');
  EXPECT_EQ(excess(reply), "sent a note of 1025 bytes, 1024 are allowed");
}

TEST(TeamLimits, NameAndVersionAreShortAndPrintable) {
  proto::TeamHello hello;
  EXPECT_EQ(excess(hello), "");
  hello.set_name(std::string(100, 'x'));
  hello.set_version("1.0 \xc3\xa4\xc2\xa0");
  EXPECT_EQ(excess(hello), "");
  hello.set_name(std::string(101, 'x'));
  EXPECT_EQ(excess(hello), "gives a name of 101 bytes, 100 are allowed");
  hello.set_name("x");
  for (const std::string text :
       {"\x1b[2J", "\n", "\x7f", "\xc2\x9b", "\xff", "\xc2", "a\xc3", "a\xe2\x80\x8b", "\xe3\x85\xa4"}) {
    hello.set_version(text);
    EXPECT_EQ(
        excess(hello),
        "gives a version with characters that control something or are not seen, or of bytes that are no "
        "UTF-8");
  }
}

TEST(TeamLimits, CopiesWhatCounts) {
  const proto::MatchReply reply = largest_reply();
  proto::MatchReply copy;
  copy_what_counts(reply, copy);
  EXPECT_EQ(copy.note(), "");
  copy.set_note(reply.note());
  EXPECT_EQ(copy.SerializeAsString(), reply.SerializeAsString());
}

TEST(TeamLimits, CopiesNoFieldsThatAreNotInTheProtocol) {
  const auto copied_size = [](const proto::MatchReply& reply) {
    proto::MatchReply copy;
    copy_what_counts(reply, copy);
    return copy.ByteSizeLong();
  };
  proto::MatchReply plain = largest_reply();
  plain.clear_note();
  const std::size_t size = plain.ByteSizeLong();
  const auto smuggle = [](proto::MatchReply& reply, int place) {
    auto add = [](auto& message) {
      message.GetReflection()->MutableUnknownFields(&message)->AddLengthDelimited(1000,
                                                                                  std::string(900, 'x'));
    };
    if (place == 0) add(reply);
    if (place == 1) add(*reply.mutable_control());
    if (place == 2) add(*reply.mutable_request());
    proto::RobotCommand& command = *reply.mutable_control()->mutable_robot_commands(7);
    if (place == 3) add(command);
    if (place == 4) add(*command.mutable_move_command());
    if (place == 5) add(*command.mutable_move_command()->mutable_wheel_velocity());
  };
  for (int place = 0; place < 6; ++place) {
    proto::MatchReply reply = plain;
    smuggle(reply, place);
    EXPECT_GT(reply.ByteSizeLong(), size + 900);
    EXPECT_EQ(copied_size(reply), size) << place;
  }
  for (const bool local : {true, false}) {
    proto::MatchReply reply;
    proto::RobotMoveCommand& move = *reply.mutable_control()->add_robot_commands()->mutable_move_command();
    google::protobuf::Message* velocity = move.mutable_global_velocity();
    if (local) velocity = move.mutable_local_velocity();
    const std::size_t before = copied_size(reply);
    velocity->GetReflection()->MutableUnknownFields(velocity)->AddLengthDelimited(1000,
                                                                                  std::string(900, 'x'));
    EXPECT_EQ(copied_size(reply), before);
  }
}

}  // namespace
}  // namespace wire
