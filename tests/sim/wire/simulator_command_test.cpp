#include "sim/wire/simulator_command.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

namespace {

namespace proto = matchday::simulation;
using testing::HasSubstr;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

template <class Message>
std::string problem_of(const std::function<void(Message&)>& fill) {
  Message message;
  fill(message);
  const auto result = wire::decode(message);
  const auto* problem = std::get_if<wire::Problem>(&result);
  return problem ? std::string(problem->code) + ": " + problem->message : "";
}

std::string bad_ball(const std::function<void(proto::TeleportBall&)>& fill) {
  return problem_of<proto::TeleportBall>(fill);
}

std::string bad_robot(const std::function<void(proto::TeleportRobot&)>& fill) {
  return problem_of<proto::TeleportRobot>([&](proto::TeleportRobot& robot) {
    robot.mutable_id()->set_id(4);
    robot.mutable_id()->set_team(proto::BLUE);
    fill(robot);
  });
}

}  // namespace

TEST(BallTeleport, KeepsApartWhatIsSaidAndWhatIsNot) {
  proto::TeleportBall message;
  auto result = wire::decode(message);
  auto ball = std::get<wire::BallTeleport>(result);
  EXPECT_FALSE(ball.says_where());
  EXPECT_FALSE(ball.says_how_fast());
  EXPECT_FALSE(ball.safely || ball.roll || ball.by_force);

  message.set_y(0);
  message.set_vz(2);
  message.set_teleport_safely(true);
  message.set_roll(true);
  message.set_by_force(true);
  ball = std::get<wire::BallTeleport>(wire::decode(message));
  EXPECT_EQ(ball.position[0], std::nullopt);
  EXPECT_EQ(ball.position[1], 0.0) << "zero is a place";
  EXPECT_EQ(ball.velocity[2], 2.0);
  EXPECT_TRUE(ball.safely && ball.roll && ball.by_force);
}

TEST(BallTeleport, RefusesWhatCannotBeMeant) {
  using Ball = proto::TeleportBall;
  EXPECT_EQ(bad_ball([](Ball& b) { b.set_x(-101); }),
            "INVALID_VALUE: teleport_ball: x = -101 must be from -100 to 100");
  EXPECT_THAT(bad_ball([](Ball& b) { b.set_y(nan_value); }), HasSubstr("y = nan"));
  EXPECT_THAT(bad_ball([](Ball& b) { b.set_z(-0.01F); }), HasSubstr("must be from 0 to 5"));
  EXPECT_THAT(bad_ball([](Ball& b) { b.set_vx(10.5F); }), HasSubstr("vx = 10.5"));
  EXPECT_THAT(bad_ball([](Ball& b) { b.set_vy(-10.5F); }), HasSubstr("vy"));
  EXPECT_THAT(bad_ball([](Ball& b) { b.set_vz(nan_value); }), HasSubstr("vz"));
}

TEST(RobotTeleport, KeepsApartWhatIsSaidAndWhatIsNot) {
  proto::TeleportRobot message;
  message.mutable_id()->set_id(15);
  message.mutable_id()->set_team(proto::YELLOW);
  auto robot = std::get<wire::RobotTeleport>(wire::decode(message));
  EXPECT_EQ(robot.id, (world::RobotId{world::Team::Yellow, 15}));
  EXPECT_FALSE(robot.says_where() || robot.says_how_fast);
  EXPECT_EQ(robot.present, std::nullopt);

  message.set_orientation(-2);
  message.set_v_y(1.5);
  message.set_present(false);
  robot = std::get<wire::RobotTeleport>(wire::decode(message));
  EXPECT_EQ(robot.orientation, -2.0);
  EXPECT_EQ(robot.velocity, world::Vector2d(0, 1.5));
  EXPECT_TRUE(robot.says_how_fast);
  EXPECT_EQ(robot.present, false);
}

TEST(RobotTeleport, RefusesWhatCannotBeMeant) {
  using Robot = proto::TeleportRobot;
  EXPECT_EQ(bad_robot([](Robot&) {}), "");
  EXPECT_THAT(bad_robot([](Robot& r) { r.clear_id(); }), HasSubstr("ROBOT_ID"));
  EXPECT_THAT(bad_robot([](Robot& r) { r.mutable_id()->set_id(16); }), HasSubstr("ROBOT_ID"));
  EXPECT_THAT(bad_robot([](Robot& r) { r.mutable_id()->set_team(proto::UNKNOWN); }), HasSubstr("ROBOT_ID"));
  EXPECT_EQ(bad_robot([](Robot& r) { r.set_x(nan_value); }),
            "INVALID_VALUE: teleport_robot, blue 4: x = nan must be from -100 to 100");
  EXPECT_THAT(bad_robot([](Robot& r) { r.set_orientation(2000); }), HasSubstr("orientation = 2000"));
  EXPECT_THAT(bad_robot([](Robot& r) { r.set_v_x(11); }), HasSubstr("v_x"));
  EXPECT_THAT(bad_robot([](Robot& r) { r.set_v_angular(-101); }), HasSubstr("v_angular"));
}
