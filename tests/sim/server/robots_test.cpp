// RobotControl and its answer: every way to move, kick, dribble; how long a command holds; feedback; errors.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/sim/server/bench.h"

namespace {

using bench::Bench;
using bench::local;
using testing::ElementsAre;
namespace proto = bench::proto;
using world::Team;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();

struct Field : Bench {
  Field() { put(Team::Blue, 1, 0, 2, 0); }
  /// Sends the same message before every tick.
  void drive(const proto::RobotControl& message, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      EXPECT_EQ(robots(Team::Blue, message).errors_size(), 0);
      steps(1);
    }
  }
  const truth::Robot& blue() const { return *robot(Team::Blue, 1); }
};

proto::RobotControl global(float x, float y, float angular) {
  proto::RobotControl message = bench::order(1);
  auto& velocity = *message.mutable_robot_commands(0)->mutable_move_command()->mutable_global_velocity();
  velocity.set_x(x);
  velocity.set_y(y);
  velocity.set_angular(angular);
  return message;
}

proto::RobotControl wheels(float front_right, float back_right, float back_left, float front_left) {
  proto::RobotControl message = bench::order(1);
  auto& rims = *message.mutable_robot_commands(0)->mutable_move_command()->mutable_wheel_velocity();
  rims.set_front_right(front_right);
  rims.set_back_right(back_right);
  rims.set_back_left(back_left);
  rims.set_front_left(front_left);
  return message;
}

std::vector<std::string> codes(const proto::RobotControlResponse& response) {
  std::vector<std::string> result;
  for (const auto& error : response.errors()) result.push_back(error.code());
  return result;
}

}  // namespace

TEST(RobotCommands, LocalVelocityIsInTheRobotsFrame) {
  Field f;
  f.put(Team::Blue, 1, 0, 2, std::numbers::pi / 2);
  f.drive(local(1, 1, 0.5), 60);
  EXPECT_NEAR(f.blue().velocity.x(), -0.5, 1e-3);  // reached long ago; floats in Bullet
  EXPECT_NEAR(f.blue().velocity.y(), 1, 1e-3);
  f.drive(local(1, 0, 0, 2), 60);
  EXPECT_NEAR(f.blue().angular_velocity, 2, 1e-3);
}

TEST(RobotCommands, GlobalVelocityStaysInTheFieldWhileTheRobotTurns) {
  Field f;
  f.drive(global(1, 0, 5), 30);
  const truth::Robot begin = f.blue();
  f.drive(global(1, 0, 5), 120);
  const world::Vector2d way = f.blue().position - begin.position;
  // Ten rad later. In a tick the robot turns by 5/60 rad; half of it to either side costs 1 - sinc = 3e-4 of
  // the way, and the drive, which has to turn its velocity back each tick, follows within a tick.
  EXPECT_NEAR(way.x(), 2, 0.02);
  EXPECT_NEAR(way.y(), 0, 0.02);
  EXPECT_NEAR(f.blue().angular_velocity, 5, 1e-3);
}

TEST(RobotCommands, WheelsDriveAsTheirAnglesSay) {
  // Standard angles: 45, 135, 225, 315 degrees clockwise. Forward at v: rims at -+v sin 45.
  Field f;
  const float rim = 0.5F / std::numbers::sqrt2_v<float>;
  f.drive(wheels(rim, rim, -rim, -rim), 60);
  EXPECT_NEAR(f.blue().velocity.x(), 0.5, 1e-3);
  EXPECT_NEAR(f.blue().velocity.y(), 0, 1e-3);
  f.drive(wheels(rim, -rim, -rim, rim), 60);
  EXPECT_NEAR(f.blue().velocity.x(), 0, 1e-3);
  EXPECT_NEAR(f.blue().velocity.y(), 0.5, 1e-3) << "to the left";
  f.drive(wheels(0.09F, 0.09F, 0.09F, 0.09F), 60);
  EXPECT_NEAR(f.blue().angular_velocity, 1, 1e-3) << "counter-clockwise; 0.09 m is the robot's radius";
  EXPECT_NEAR(f.blue().velocity.norm(), 0, 1e-3);
}

TEST(RobotCommands, HoldForATenthOfASecond) {
  Field f;
  f.robots(Team::Blue, local(1, 3));
  // Commands take effect a tick late (radio.latency = 1). Six ticks at 3 m/s^2, then braking at 6.
  f.steps(1);
  EXPECT_EQ(f.blue().velocity.x(), 0);
  f.steps(6);
  EXPECT_NEAR(f.blue().velocity.x(), 0.3, 1e-5);
  f.steps(1);
  EXPECT_NEAR(f.blue().velocity.x(), 0.2, 1e-5);
  f.steps(10);
  EXPECT_NEAR(f.blue().velocity.x(), 0, 1e-6);
}

TEST(RobotCommands, ANewCommandTakesTheTimeAnew) {
  Field f;
  f.robots(Team::Blue, local(1, 3));
  f.steps(6);
  f.robots(Team::Blue, local(1, 3));
  f.steps(6);
  f.steps(1);
  EXPECT_NEAR(f.blue().velocity.x(), 0.6, 1e-5);
}

TEST(RobotCommands, AnEmptyOneStopsTheRobot) {
  Field f;
  f.drive(local(1, 3), 20);
  f.drive(bench::order(1), 20);
  EXPECT_NEAR(f.blue().velocity.norm(), 0, 1e-6);
}

TEST(RobotCommands, KickFlatAndHigh) {
  for (const float degrees : {0.0F, 45.0F}) {
    Field f;
    f.put_ball(0.073 + 0.0215 + 0.002, 2);
    proto::RobotControl message = bench::order(1);
    message.mutable_robot_commands(0)->set_kick_speed(4);
    message.mutable_robot_commands(0)->set_kick_angle(degrees);
    f.robots(Team::Blue, message);
    f.steps(1);
    ASSERT_TRUE(f.server.simulation().truth().kicks.empty()) << "a tick late";
    f.steps(1);
    ASSERT_EQ(f.server.simulation().truth().kicks.size(), 1U);
    const world::Vector3d kicked = f.server.simulation().truth().kicks[0].velocity;
    const double angle = static_cast<double>(degrees) * std::numbers::pi / 180;
    EXPECT_NEAR(kicked.x(), 4 * std::cos(angle), 1e-3);
    EXPECT_NEAR(kicked.z(), 4 * std::sin(angle), 1e-3);
  }
}

TEST(RobotCommands, DribbleHoldsTheBallWhileDrivingBackwards) {
  for (const float rpm : {0.0F, 5000.0F}) {
    Field f;
    f.put_ball(0.073 + 0.0215 + 0.002, 2);
    proto::RobotControl message = local(1, -0.5);
    message.mutable_robot_commands(0)->set_dribbler_speed(rpm);
    f.drive(message, 60);
    const double gap = f.ball().position.x() - f.blue().position.x() - 0.073 - 0.0215;
    if (rpm > 0) {
      EXPECT_LT(gap, 0.015) << "within the dribbler's reach";
    } else {
      EXPECT_GT(gap, 0.1);
    }
  }
}

TEST(Feedback, NamesEveryRobotOfTheTeamAndWhoHasTheBall) {
  Field f;
  f.put(Team::Yellow, 12, -2, 2);
  const auto numbers = [](const proto::RobotControlResponse& response) {
    std::vector<unsigned> result;
    for (const auto& robot : response.feedback()) result.push_back(robot.id());
    return result;
  };
  EXPECT_THAT(numbers(f.robots(Team::Yellow, {})), ElementsAre(0, 1, 12));
  f.put_ball(0.073 + 0.0215 + 0.002, 2);
  f.steps(1);
  const auto response = f.robots(Team::Blue, {});
  EXPECT_THAT(numbers(response), ElementsAre(0, 1));
  EXPECT_TRUE(response.feedback(0).has_dribbler_ball_contact());
  EXPECT_FALSE(response.feedback(0).dribbler_ball_contact());
  EXPECT_TRUE(response.feedback(1).dribbler_ball_contact());
}

TEST(RobotPort, RefusesCommandByCommand) {
  Field f;
  proto::RobotControl message = local(1, 1);
  *message.add_robot_commands() = local(1, -1).robot_commands(0);
  *message.add_robot_commands() = local(5, 1).robot_commands(0);
  *message.add_robot_commands() = local(16, 1).robot_commands(0);
  *message.add_robot_commands() = local(0, nan_value).robot_commands(0);
  message.add_robot_commands();
  const auto response = f.robots(Team::Blue, message);
  EXPECT_THAT(codes(response),
              ElementsAre("DUPLICATE_ROBOT", "ROBOT_ABSENT", "ROBOT_ID", "INVALID_VALUE", "ROBOT_ID"));
  EXPECT_EQ(response.feedback_size(), 2);
  f.steps(6);
  EXPECT_GT(f.blue().velocity.x(), 0.1) << "the first command counts";
  EXPECT_EQ(f.server.robot_counts(Team::Blue).refused.at("ROBOT_ID"), 2U);
  EXPECT_EQ(f.server.robot_counts(Team::Yellow).messages, 0U);
}

TEST(RobotPort, AnswersNonsenseWithFeedbackToo) {
  Field f;
  proto::RobotControlResponse response;
  ASSERT_TRUE(response.ParseFromString(f.server.handle_robots(Team::Blue, "\xff\xff")));
  EXPECT_THAT(codes(response), ElementsAre("UNREADABLE"));
  EXPECT_EQ(response.feedback_size(), 2);
  ASSERT_TRUE(response.ParseFromString(f.server.handle_robots(Team::Blue, std::string(10'000, 'x'))));
  EXPECT_THAT(codes(response), ElementsAre("TOO_LONG"));
}

TEST(RobotPort, ARobotThatLeftIsNotDrivenByOldCommands) {
  Field f;
  f.robots(Team::Blue, local(1, 3));
  proto::SimulatorCommand command;
  auto& robot = *command.mutable_control()->add_teleport_robot();
  robot.mutable_id()->set_id(1);
  robot.mutable_id()->set_team(proto::BLUE);
  robot.set_present(false);
  f.control(command);
  f.put(Team::Blue, 1, 0, 2);
  f.steps(5);
  EXPECT_EQ(f.blue().velocity.norm(), 0);
}
