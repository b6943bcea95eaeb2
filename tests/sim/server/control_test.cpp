// SimulatorControl: teleporting ball and robots, simulation speed; what each field does and what is refused.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "sim/world/random.h"
#include "tests/sim/server/bench.h"

namespace {

using bench::Bench;
using testing::HasSubstr;
namespace proto = bench::proto;
using world::Team;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr double radius = 0.0215;  // [m] of the ball

struct BallBench : Bench {
  BallBench() {  // the robots of the line-up are out of the way
    put(Team::Yellow, 0, -4, -2);
    put(Team::Blue, 0, 4, -2);
    put(Team::Yellow, 1, -4, -3);
    put(Team::Blue, 1, 4, -3);
  }
  proto::SimulatorCommand command;
  proto::TeleportBall& wish() { return *command.mutable_control()->mutable_teleport_ball(); }
};

struct RobotBench : Bench {
  proto::SimulatorCommand command;
  proto::TeleportRobot& wish(unsigned number, Team team = Team::Blue) {
    auto& robot = *command.mutable_control()->add_teleport_robot();
    robot.mutable_id()->set_id(number);
    robot.mutable_id()->set_team(bench::colour(team));
    return robot;
  }
};

}  // namespace

TEST(TeleportBall, WhatIsNotSaidStaysAsItIs) {
  BallBench b;
  b.wish().set_x(1);
  b.wish().set_y(-2);
  b.wish().set_vx(0.5);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.ball().position.x(), 1);
  EXPECT_EQ(b.ball().position.y(), -2);
  EXPECT_EQ(b.ball().velocity.x(), 0.5);

  b.command.Clear();
  b.wish().set_y(1.25);
  b.wish().set_vy(-1);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.ball().position.x(), 1);
  EXPECT_EQ(b.ball().position.y(), 1.25);
  EXPECT_EQ(b.ball().velocity.x(), 0.5);
  EXPECT_EQ(b.ball().velocity.y(), -1);
}

TEST(TeleportBall, HeightCountsFromTheRestingBall) {
  BallBench b;
  b.wish().set_z(1);
  b.wish().set_vz(2);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_DOUBLE_EQ(b.ball().position.z(), 1 + radius);
  EXPECT_EQ(b.ball().velocity.z(), 2);
  // 12 ticks later, still in the air: z0 + v t - g t^2 / 2; Bullet computes in floats, 1e-6 of a metre.
  b.steps(12);
  EXPECT_NEAR(b.ball().position.z(), 1 + radius + 2 * 0.2 - 9.81 * 0.2 * 0.2 / 2, 1e-5);
}

TEST(TeleportBall, ARollingBallGoesFartherThanASlidingOne) {
  BallBench b;
  b.wish().set_vx(2);
  b.wish().set_vy(0);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.ball().spin, world::Vector3d::Zero());
  b.steps(30);
  // Slides at 3 m/s^2 until 5/7 of its speed (t = 4/21 s), then rolls at 0.26 m/s^2.
  const double slide = 2.0 / 7 * 2 / 3;
  const double rest = 0.5 - slide;
  const double roll_speed = 10.0 / 7;
  EXPECT_NEAR(b.ball().position.x(), 2 * slide - 1.5 * slide * slide + roll_speed * rest - 0.13 * rest * rest,
              0.002)
      << "the change from sliding to rolling falls inside a substep: up to 1/240 s at 0.5 m/s";

  BallBench rolling;
  rolling.wish().set_vx(2);
  rolling.wish().set_vy(0);
  rolling.wish().set_roll(true);
  EXPECT_EQ(rolling.codes(rolling.command), "");
  EXPECT_NEAR(rolling.ball().spin.y(), 2 / radius, 1e-9);
  rolling.steps(30);
  EXPECT_NEAR(rolling.ball().position.x(), 2 * 0.5 - 0.13 * 0.25, 1e-4) << "closed form; floats in Bullet";
}

TEST(TeleportBall, SafelyPushesRobotsOutOfTheWay) {
  BallBench b;
  b.put(Team::Blue, 1, 2, 1);
  b.wish().set_x(2);
  b.wish().set_y(1.05F);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.robot(Team::Blue, 1)->position, world::Vector2d(2, 1)) << "not asked for";
  b.wish().set_teleport_safely(true);
  EXPECT_EQ(b.codes(b.command), "");
  const double distance = (b.robot(Team::Blue, 1)->position - b.ball().position.head<2>()).norm();
  EXPECT_GE(distance, 0.073 + 0.15 - 1e-6) << "hull to ball, at the flat front the nearest";
  EXPECT_EQ(b.ball().position.x(), 2);
}

TEST(TeleportBall, ByForceDragsItThereAndHoldsItUntilToldOtherwise) {
  BallBench b;
  b.wish().set_x(1);
  b.wish().set_y(2);
  b.wish().set_vx(9);  // does not count
  b.wish().set_by_force(true);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.ball().position.x(), 0) << "no jump";
  double fastest = 0;
  for (int i = 0; i < 180; ++i) {
    const world::Vector3d before = b.ball().position;
    b.steps(1);
    fastest = std::max(fastest, (b.ball().position - before).norm() * 60);
  }
  EXPECT_LE(fastest, 3.01) << "3 m/s and rounding";
  EXPECT_NEAR(b.ball().position.x(), 1, 0.005);  // where friction balances the pull: README
  EXPECT_NEAR(b.ball().position.y(), 2, 0.005);

  b.command.Clear();
  b.wish().set_by_force(false);
  EXPECT_EQ(b.codes(b.command), "");
  const world::Vector3d there = b.ball().position;
  b.steps(60);
  EXPECT_LT((b.ball().position - there).norm(), 0.01) << "an empty message ends it without a jump";
  b.command.Clear();
  b.wish().set_vx(1);
  EXPECT_EQ(b.codes(b.command), "");
  b.steps(60);
  EXPECT_GT(b.ball().position.x(), there.x() + 0.3) << "nothing holds it any more";
}

TEST(TeleportBall, ByForceHoldsItInTheAirToo) {
  BallBench b;
  b.wish().set_z(0.5);
  b.wish().set_by_force(true);
  EXPECT_EQ(b.codes(b.command), "");
  b.steps(180);
  for (int i = 0; i < 30; ++i) {
    b.steps(1);
    EXPECT_NEAR(b.ball().position.z(), 0.5 + radius, 0.002);
  }
}

TEST(TeleportBall, WhatCannotBeMeantChangesNothing) {
  for (const auto spoil :
       {+[](proto::TeleportBall& w) { w.set_x(99); }, +[](proto::TeleportBall& w) { w.set_x(5.19F); },
        +[](proto::TeleportBall& w) { w.set_y(-3.69F); }, +[](proto::TeleportBall& w) { w.set_z(-1); },
        +[](proto::TeleportBall& w) { w.set_vx(nan_value); },
        +[](proto::TeleportBall& w) {
          w.set_vx(8);
          w.set_vy(8);
        }}) {
    BallBench b;
    b.wish().set_y(1);
    spoil(b.wish());
    EXPECT_EQ(b.codes(b.command), "INVALID_VALUE ");
    EXPECT_EQ(b.ball().position.y(), 0);
    EXPECT_EQ(b.ball().velocity, world::Vector3d::Zero());
  }
}

TEST(TeleportRobot, WhatIsNotSaidStaysAndMotionIsZero) {
  RobotBench b;
  b.put(Team::Blue, 1, 2, 1, 0.5);
  auto& wish = b.wish(1);
  wish.set_y(-1);
  wish.set_v_x(1.5);
  wish.set_v_angular(-3);
  EXPECT_EQ(b.codes(b.command), "");
  const truth::Robot& robot = *b.robot(Team::Blue, 1);
  EXPECT_EQ(robot.position, world::Vector2d(2, -1));
  EXPECT_NEAR(robot.orientation, 0.5, 1e-6) << "a float in Bullet";
  EXPECT_NEAR(robot.velocity.x(), 1.5, 1e-6);
  EXPECT_EQ(robot.velocity.y(), 0);
  EXPECT_NEAR(robot.angular_velocity, -3, 1e-6);

  b.command.Clear();
  b.wish(1).set_orientation(7);  // more than a turn
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.robot(Team::Blue, 1)->position, world::Vector2d(2, -1));
  EXPECT_NEAR(b.robot(Team::Blue, 1)->orientation, 7 - 2 * M_PI, 1e-6);
  EXPECT_EQ(b.robot(Team::Blue, 1)->velocity, world::Vector2d::Zero());
}

TEST(TeleportRobot, ComesAndGoes) {
  RobotBench b;
  auto& there = b.wish(9, Team::Yellow);
  there.set_present(true);
  there.set_x(1);
  there.set_y(2);
  EXPECT_EQ(b.codes(b.command), "");
  ASSERT_NE(b.robot(Team::Yellow, 9), nullptr);
  EXPECT_EQ(b.robot(Team::Yellow, 9)->position, world::Vector2d(1, 2));
  EXPECT_EQ(b.robots(Team::Yellow, {}).feedback_size(), 3);

  b.command.Clear();
  b.wish(9, Team::Yellow).set_present(true);  // is there already, and nothing else is said
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.robot(Team::Yellow, 9)->position, world::Vector2d(1, 2));

  b.command.Clear();
  auto& gone = b.wish(9, Team::Yellow);
  gone.set_present(false);
  gone.set_x(50);  // a robot that leaves needs no place
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.robot(Team::Yellow, 9), nullptr);
  EXPECT_EQ(b.codes(b.command), "") << "gone is gone";
  b.command.Clear();
  b.wish(7).set_present(false);
  EXPECT_EQ(b.codes(b.command), "") << "who was never there too";
}

TEST(TeleportRobot, ByForceDragsItThereAndHoldsIt) {
  RobotBench b;
  b.put(Team::Blue, 1, 0, 2, 0);
  auto& wish = b.wish(1);
  wish.set_x(1);
  wish.set_orientation(2);
  wish.set_by_force(true);
  EXPECT_EQ(b.codes(b.command), "");
  EXPECT_EQ(b.robot(Team::Blue, 1)->position.x(), 0) << "no jump";
  for (int i = 0; i < 180; ++i) {  // its own commands do not free it
    b.robots(Team::Blue, bench::local(1, -3));
    b.steps(1);
  }
  EXPECT_NEAR(b.robot(Team::Blue, 1)->position.x(), 1, 0.002);
  EXPECT_NEAR(b.robot(Team::Blue, 1)->position.y(), 2, 0.002);
  EXPECT_NEAR(b.robot(Team::Blue, 1)->orientation, 2, 0.01);

  b.command.Clear();
  b.wish(1);
  EXPECT_EQ(b.codes(b.command), "") << "an empty message ends it";
  b.robots(Team::Blue, bench::local(1, 1));
  b.steps(6);
  EXPECT_GT(b.robot(Team::Blue, 1)->velocity.norm(), 0.1);
}

TEST(TeleportRobot, WhatCannotBeDoneChangesNothing) {
  RobotBench b;
  const auto code = [&](const std::function<void(proto::TeleportRobot&)>& fill, unsigned number = 1) {
    b.command.Clear();
    fill(b.wish(number));
    return b.codes(b.command);
  };
  const auto before = *b.robot(Team::Blue, 1);
  EXPECT_EQ(code([](auto& r) { r.set_x(1); }, 7), "ROBOT_ABSENT ");
  EXPECT_EQ(code([](auto& r) { r.set_present(true); }, 7), "CREATE_NOPOS_ROBOT ");
  EXPECT_EQ(code(
                [](auto& r) {
                  r.set_present(true);
                  r.set_x(1);
                },
                7),
            "CREATE_NOPOS_ROBOT ");
  EXPECT_EQ(code([](auto& r) { r.set_x(5.12F); }), "INVALID_VALUE ") << "5.2 m to the wall, 0.09 m robot";
  EXPECT_EQ(code([](auto& r) { r.set_y(nan_value); }), "INVALID_VALUE ");
  EXPECT_EQ(code([](auto& r) { r.clear_id(); }), "ROBOT_ID ");
  EXPECT_EQ(code([](auto& r) { r.mutable_id()->set_id(16); }), "ROBOT_ID ");
  EXPECT_EQ(b.robot(Team::Blue, 7), nullptr);
  EXPECT_EQ(b.robot(Team::Blue, 1)->position, before.position);

  const auto sentence = [&](const std::function<void(proto::TeleportRobot&)>& fill) {
    b.command.Clear();
    fill(b.wish(1));
    return b.control(b.command).errors(0).message();
  };
  EXPECT_EQ(sentence([](auto& r) { r.mutable_id()->set_id(16); }),
            "teleport_robot: the id has team BLUE and number 16; it must have a team, YELLOW or BLUE, and a "
            "number, 0 to 15");
  EXPECT_EQ(sentence([](auto& r) { r.set_v_x(10.1F); }),
            "teleport_robot, blue 1: v_x = 10.1 must be from -10 to 10")
      << "as it was written";

  b.command.Clear();
  b.wish(99);
  b.wish(1).set_x(3);
  EXPECT_EQ(b.codes(b.command), "ROBOT_ID ") << "the rest is done";
  EXPECT_EQ(b.robot(Team::Blue, 1)->position.x(), 3);
}

TEST(SimulationSpeed, IsAnyUsefulFactorOrAPause) {
  Bench b;
  const auto ask = [&](float speed) {
    proto::SimulatorCommand command;
    command.mutable_control()->set_simulation_speed(speed);
    return b.codes(command);
  };
  for (const float speed : {0.5F, 4.0F, 0.0F, 0.01F, 1000.0F}) {
    EXPECT_EQ(ask(speed), "");
    EXPECT_EQ(b.server.speed(), static_cast<double>(speed));
  }
  for (const float speed : {-1.0F, 0.009F, 1001.0F, nan_value, std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(ask(speed), "INVALID_SPEED ");
    EXPECT_EQ(b.server.speed(), 1000);
  }
}

TEST(ControlPort, AnswersEveryDatagramOnce) {
  Bench b;
  const auto code = [&](std::string_view bytes) {
    proto::SimulatorResponse response;
    EXPECT_TRUE(response.ParseFromString(b.server.handle_control(bytes)));
    return response.errors_size() == 0 ? "" : response.errors(0).code();
  };
  EXPECT_EQ(code(""), "") << "an empty command is a command";
  EXPECT_EQ(code("\xff\xff\xff"), "UNREADABLE");
  EXPECT_EQ(code(std::string(8193, '\0')), "TOO_LONG");
  EXPECT_EQ(code(std::string(8192, '\0')), "UNREADABLE");
  EXPECT_EQ(b.server.control_counts().messages, 4U);
  EXPECT_EQ(b.server.control_counts().refused.at("UNREADABLE"), 2U);
  EXPECT_EQ(b.server.control_counts().refused.at("TOO_LONG"), 1U);
}

TEST(ControlPort, ManyErrorsStillFitInADatagram) {
  Bench b;
  proto::SimulatorCommand command;
  for (int i = 0; i < 2000; ++i) command.mutable_control()->add_teleport_robot();
  const std::string answer = b.server.handle_control(command.SerializeAsString());
  EXPECT_LE(answer.size(), 8192U);
  proto::SimulatorResponse response;
  ASSERT_TRUE(response.ParseFromString(answer));
  ASSERT_EQ(response.errors_size(), 24);
  EXPECT_THAT(response.errors(23).message(), HasSubstr("and 1976 more errors"));
  EXPECT_EQ(b.server.control_counts().refused.at("ROBOT_ID"), 2000U);
}
